#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string_view>

namespace gradmesh {

/// A CSS colour as (r, g, b, a), 0..1, sRGB, not premultiplied: a name, #rgb, #rgba, #rrggbb,
/// #rrggbbaa, rgb(), rgba(), hsl(), hsla(), `transparent`, any of them with an `icc-color()` after
/// it, which is ignored. `currentColor` and `inherit` are the caller's. Nothing if it is none.
std::optional<glm::dvec4> parse_color(std::string_view text);

}  // namespace gradmesh
