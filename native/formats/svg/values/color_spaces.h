#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace gradmesh {

/// Return colours of the spaces of CSS Color 4 as sRGB, (r, g, b). Hues are in degrees. What is
/// outside of sRGB stays outside of 0..1: the caller clips the channels, as browsers and Inkscape
/// 1.5 do.

/// From hue, saturation and lightness, the latter two clamped to 0..1 (section 7.1).
glm::dvec3 hsl_to_rgb(const glm::dvec3& hsl);
/// From hue, whiteness and blackness, 1 being all (section 8.1).
glm::dvec3 hwb_to_rgb(const glm::dvec3& hwb);
/// From CIE Lab with the white of D50, lightness 0..100 (section 9.3).
glm::dvec3 lab_to_rgb(const glm::dvec3& lab);
/// From lightness, chroma and hue of the same.
glm::dvec3 lch_to_rgb(const glm::dvec3& lch);
/// From Oklab, lightness 0..1 (section 9.4).
glm::dvec3 oklab_to_rgb(const glm::dvec3& oklab);
/// From lightness, chroma and hue of the same.
glm::dvec3 oklch_to_rgb(const glm::dvec3& oklch);

/// From the spaces of color() (section 10), 1 being the most of a channel.
glm::dvec3 srgb_linear_to_rgb(const glm::dvec3& linear);
glm::dvec3 display_p3_to_rgb(const glm::dvec3& p3);
glm::dvec3 a98_to_rgb(const glm::dvec3& a98);
glm::dvec3 prophoto_to_rgb(const glm::dvec3& prophoto);
glm::dvec3 rec2020_to_rgb(const glm::dvec3& rec2020);
glm::dvec3 xyz_d65_to_rgb(const glm::dvec3& xyz);
glm::dvec3 xyz_d50_to_rgb(const glm::dvec3& xyz);

/// From cyan, magenta, yellow and black, 1 being all of an ink, without a profile (CSS Color 5,
/// "Uncalibrated CMYK colors"), as Inkscape 1.5 shows it.
glm::dvec3 cmyk_to_rgb(const glm::dvec4& cmyk);

}  // namespace gradmesh
