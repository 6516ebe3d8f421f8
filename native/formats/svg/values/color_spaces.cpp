#include "formats/svg/values/color_spaces.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace gradmesh {
namespace {

/// A matrix by rows, as CSS Color 4 prints them in "Sample code for Color Conversions".
struct Rows {
  glm::dvec3 rows[3];
};

glm::dvec3 operator*(const Rows& m, const glm::dvec3& v) {
  return {glm::dot(m.rows[0], v), glm::dot(m.rows[1], v), glm::dot(m.rows[2], v)};
}

constexpr Rows xyz_to_linear_srgb{{{12831. / 3959, -329. / 214, -1974. / 3959},
                                   {-851781. / 878810, 1648619. / 878810, 36519. / 878810},
                                   {705. / 12673, -2585. / 12673, 705. / 667}}};
constexpr Rows p3_to_xyz{{{608311. / 1250200, 189793. / 714400, 198249. / 1000160},
                          {35783. / 156275, 247089. / 357200, 198249. / 2500400},
                          {0, 32229. / 714400, 5220557. / 5000800}}};
constexpr Rows a98_to_xyz{{{573536. / 994567, 263643. / 1420810, 187206. / 994567},
                           {591459. / 1989134, 6239551. / 9945670, 374412. / 4972835},
                           {53769. / 1989134, 351524. / 4972835, 4929758. / 4972835}}};
constexpr Rows prophoto_to_xyz_d50{{{0.79776664490064230, 0.13518129740053308, 0.03134773412839220},
                                    {0.28807482881940130, 0.71183523424187300, 0.00008993693872564},
                                    {0, 0, 0.82510460251046020}}};
constexpr Rows rec2020_to_xyz{{{63426534. / 99577255, 20160776. / 139408157, 47086771. / 278816314},
                               {26158966. / 99577255, 472592308. / 697040785, 8267143. / 139408157},
                               {0, 19567812. / 697040785, 295819943. / 278816314}}};
/// By Bradford's adaptation.
constexpr Rows d50_to_d65{{{0.955473421488075, -0.02309845494876471, 0.06325924320057072},
                           {-0.0283697093338637, 1.0099953980813041, 0.021041441191917323},
                           {0.012314014864481998, -0.020507649298898964, 1.330365926242124}}};
constexpr Rows oklab_to_cones{{{1, 0.3963377773761749, 0.2158037573099136},
                               {1, -0.1055613458156586, -0.0638541728258133},
                               {1, -0.0894841775298119, -1.2914855480194092}}};
constexpr Rows cones_to_xyz{{{1.2268798758459243, -0.5578149944602171, 0.2813910456659647},
                             {-0.0405757452148008, 1.1122868032803170, -0.0717110580655164},
                             {-0.0763729366746601, -0.4214933324022432, 1.5869240198367816}}};

/// Returns the vector with `curve` applied to the size of each channel, which keeps its sign.
template <class Curve>
glm::dvec3 each(const glm::dvec3& v, const Curve& curve) {
  const auto signed_curve = [&](double x) { return std::copysign(curve(std::abs(x)), x); };
  return {signed_curve(v.x), signed_curve(v.y), signed_curve(v.z)};
}

double decode_srgb(double x) {
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}
double encode_srgb(double x) {
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}
double decode_prophoto(double x) { return x <= 16. / 512 ? x / 16 : std::pow(x, 1.8); }
double decode_rec2020(double x) {
  constexpr double alpha = 1.09929682680944, beta = 0.018053968510807;
  return x < beta * 4.5 ? x / 4.5 : std::pow((x + alpha - 1) / alpha, 1 / 0.45);
}

/// Returns lightness, a and b of lightness, chroma and hue.
glm::dvec3 from_polar(const glm::dvec3& lch) {
  const double hue = glm::radians(std::fmod(lch.z, 360.0)), chroma = std::max(lch.y, 0.0);
  return {lch.x, chroma * std::cos(hue), chroma * std::sin(hue)};
}

}  // namespace

glm::dvec3 hsl_to_rgb(const glm::dvec3& hsl) {
  const double saturation = std::clamp(hsl.y, 0.0, 1.0), lightness = std::clamp(hsl.z, 0.0, 1.0);
  const double chroma = saturation * std::min(lightness, 1 - lightness);
  const auto channel = [&](double n) {
    double k = std::fmod(n + hsl.x / 30.0, 12.0);
    if (k < 0) k += 12.0;
    return lightness - chroma * std::max(-1.0, std::min({k - 3.0, 9.0 - k, 1.0}));
  };
  return {channel(0), channel(8), channel(4)};
}

glm::dvec3 hwb_to_rgb(const glm::dvec3& hwb) {
  const double white = std::max(hwb.y, 0.0), black = std::max(hwb.z, 0.0);
  if (white + black >= 1) return glm::dvec3(white / (white + black));
  return hsl_to_rgb({hwb.x, 1, 0.5}) * (1 - white - black) + white;
}

glm::dvec3 lab_to_rgb(const glm::dvec3& lab) {
  constexpr double kappa = 24389. / 27, epsilon = 216. / 24389;
  constexpr glm::dvec3 white(0.3457 / 0.3585, 1, (1 - 0.3457 - 0.3585) / 0.3585);
  const double lightness = std::clamp(lab.x, 0.0, 100.0), y = (lightness + 16) / 116;
  const auto cubed = [](double f) {
    return f * f * f > epsilon ? f * f * f : (116 * f - 16) / kappa;
  };
  return xyz_d50_to_rgb(white *
                        glm::dvec3(cubed(y + lab.y / 500), cubed(y), cubed(y - lab.z / 200)));
}

glm::dvec3 lch_to_rgb(const glm::dvec3& lch) { return lab_to_rgb(from_polar(lch)); }

glm::dvec3 oklab_to_rgb(const glm::dvec3& oklab) {
  const glm::dvec3 cones =
      oklab_to_cones * glm::dvec3(std::clamp(oklab.x, 0.0, 1.0), oklab.y, oklab.z);
  return xyz_d65_to_rgb(cones_to_xyz * (cones * cones * cones));
}

glm::dvec3 oklch_to_rgb(const glm::dvec3& oklch) { return oklab_to_rgb(from_polar(oklch)); }

glm::dvec3 srgb_linear_to_rgb(const glm::dvec3& linear) { return each(linear, encode_srgb); }

glm::dvec3 display_p3_to_rgb(const glm::dvec3& p3) {
  return xyz_d65_to_rgb(p3_to_xyz * each(p3, decode_srgb));
}

glm::dvec3 a98_to_rgb(const glm::dvec3& a98) {
  const auto decode = [](double x) { return std::pow(x, 563. / 256); };
  return xyz_d65_to_rgb(a98_to_xyz * each(a98, decode));
}

glm::dvec3 prophoto_to_rgb(const glm::dvec3& prophoto) {
  return xyz_d50_to_rgb(prophoto_to_xyz_d50 * each(prophoto, decode_prophoto));
}

glm::dvec3 rec2020_to_rgb(const glm::dvec3& rec2020) {
  return xyz_d65_to_rgb(rec2020_to_xyz * each(rec2020, decode_rec2020));
}

glm::dvec3 xyz_d65_to_rgb(const glm::dvec3& xyz) {
  return srgb_linear_to_rgb(xyz_to_linear_srgb * xyz);
}

glm::dvec3 xyz_d50_to_rgb(const glm::dvec3& xyz) { return xyz_d65_to_rgb(d50_to_d65 * xyz); }

glm::dvec3 cmyk_to_rgb(const glm::dvec4& cmyk) {
  const glm::dvec4 ink = glm::clamp(cmyk, 0.0, 1.0);
  return (1.0 - glm::dvec3(ink)) * (1 - ink.w);
}

}  // namespace gradmesh
