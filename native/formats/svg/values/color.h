#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string_view>

namespace gradmesh {

/// A colour as Inkscape 1.2 reads it, (r, g, b), 0..1, sRGB: a name, #rgb, #rrggbb, rgb() or hsl()
/// with commas. What follows after a blank, such as an `icc-color()`, is ignored. `currentColor`
/// and `inherit` are the caller's. Nothing if it is none, as are all forms with an opacity.
std::optional<glm::dvec3> parse_color(std::string_view text);

}  // namespace gradmesh
