#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace gradmesh {

/// Returns a colour of CSS Color 4, (r, g, b, opacity), 0..1, sRGB, as Inkscape 1.5 reads it: a
/// name, #rgb, #rgba, #rrggbb, #rrggbbaa, rgb(), hsl(), hwb(), lab(), lch(), oklab(), oklch(),
/// color() of its spaces, or device-cmyk(). Arguments may be separated by commas everywhere, and
/// need no `%`. Channels outside of sRGB are clipped. What follows after a colour and a blank, such
/// as an `icc-color()`, is ignored. `currentColor` and `inherit` are left to the caller. Returns
/// nothing if the text is no colour.
std::optional<glm::dvec4> parse_translucent_color(std::string_view text);

/// Returns an opaque colour, (r, g, b), of parse_translucent_color(); nothing for others.
std::optional<glm::dvec3> parse_color(std::string_view text);

/// Returns a colour, (r, g, b), 0..1, as `#rrggbb`, or `#rgb` where that is the same.
std::string color_text(const glm::dvec3& color);

/// Returns the part of a text that is a colour which `color_text` could not give back as it stands:
/// a function, `#rgba`, `#rrggbbaa`, or any hexadecimal form with an `icc-color()`. Returns an
/// empty string for names, `#rgb`, `#rrggbb` and what is no colour.
std::string own_color_text(std::string_view text);

}  // namespace gradmesh
