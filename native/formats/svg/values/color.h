#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace gradmesh {

/// Returns a colour as Inkscape 1.2 reads it, (r, g, b), 0..1, sRGB: a name, #rgb, #rrggbb, rgb()
/// or hsl() with commas. What follows after a blank, such as an `icc-color()`, is ignored.
/// `currentColor` and `inherit` are left to the caller. Returns nothing if the text is no colour,
/// which includes all forms with an opacity.
std::optional<glm::dvec3> parse_color(std::string_view text);

/// Returns a colour, (r, g, b), 0..1, as `#rrggbb`, or `#rgb` where that is the same.
std::string color_text(const glm::dvec3& color);

}  // namespace gradmesh
