#include "formats/pdf/color/color_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "base/error.h"
#include "formats/pdf/color/cie.h"
#include "formats/pdf/color/function_rule.h"

namespace gradmesh {
namespace {

/// What poppler shows for full amounts of cyan (8), magenta (4), yellow (2) and black (1), in
/// levels of sRGB: pixels that pdftoppm paints. The figures are those of its
/// poppler/GfxState_helpers.h.
constexpr std::array<glm::ivec3, 16> cmyk_corners{glm::ivec3{255, 255, 255},
                                                  {35, 31, 32},
                                                  {255, 242, 0},
                                                  {28, 26, 0},
                                                  {236, 0, 140},
                                                  {36, 0, 0},
                                                  {237, 28, 36},
                                                  {34, 0, 0},
                                                  {0, 173, 239},
                                                  {0, 15, 36},
                                                  {0, 166, 80},
                                                  {0, 19, 0},
                                                  {46, 49, 146},
                                                  {0, 0, 2},
                                                  {54, 54, 57},
                                                  {0, 0, 0}};

/// Returns the multilinear blend of the sixteen corners.
glm::dvec3 cmyk_to_srgb(std::span<const double> cmyk) {
  glm::dvec3 blend(0.0);
  for (unsigned corner = 0; corner < cmyk_corners.size(); ++corner) {
    double weight = 1;
    for (unsigned i = 0; i < 4; ++i) weight *= corner >> (3 - i) & 1 ? cmyk[i] : 1 - cmyk[i];
    blend += weight * glm::dvec3(cmyk_corners[corner]);
  }
  return blend / 255.0;
}

[[noreturn]] void throw_unfit_space() {
  throw InputError("a colour space of its shading has parts that do not fit together");
}

double checked_gamma(double gamma) {
  if (!(gamma > 0 && gamma <= max_pdf_number)) throw_unfit_space();
  return gamma;
}

}  // namespace

ColorSpace ColorSpace::device_gray() {
  return {{{0, 1}}, [](std::span<const double> c) { return glm::dvec3(c[0]); }};
}

ColorSpace ColorSpace::device_rgb() {
  return {std::vector<ValueRange>(3),
          [](std::span<const double> c) { return glm::dvec3(c[0], c[1], c[2]); }};
}

ColorSpace ColorSpace::device_cmyk() { return {std::vector<ValueRange>(4), cmyk_to_srgb}; }

ColorSpace ColorSpace::cal_gray(double gamma) {
  checked_gamma(gamma);
  return {std::vector<ValueRange>(1), [gamma](std::span<const double> c) {
            return encoded_srgb(glm::dvec3(std::pow(c[0], gamma)));
          }};
}

ColorSpace ColorSpace::cal_rgb(const CalRgbParameters& parameters) {
  glm::dmat3 matrix = parameters.matrix;
  for (int i = 0; i < 3; ++i) {
    checked_gamma(parameters.gamma[i]);
    for (int k = 0; k < 3; ++k) matrix[i][k] = pdf_number(matrix[i][k]);
  }
  const glm::dmat3 to_linear = xyz_to_linear_srgb(parameters.white_point) * matrix;
  const glm::dvec3 gamma = parameters.gamma;
  return {std::vector<ValueRange>(3), [gamma, to_linear](std::span<const double> c) {
            const glm::dvec3 abc(std::pow(c[0], gamma.x), std::pow(c[1], gamma.y),
                                 std::pow(c[2], gamma.z));
            return encoded_srgb(to_linear * abc);
          }};
}

ColorSpace ColorSpace::lab(const LabParameters& parameters) {
  std::vector<ValueRange> ranges{{0, 100}, parameters.a_range, parameters.b_range};
  limit_ranges(ranges);
  for (const ValueRange& range : ranges)
    if (range.low > range.high) throw_unfit_space();
  const glm::dvec3 white = parameters.white_point;
  const glm::dmat3 to_linear = xyz_to_linear_srgb(white);
  return {std::move(ranges), [white, to_linear](std::span<const double> c) {
            return encoded_srgb(to_linear * lab_to_xyz({c[0], c[1], c[2]}, white));
          }};
}

ColorSpace ColorSpace::icc_based(int components) {
  if (components == 1) return device_gray();
  if (components == 3) return device_rgb();
  if (components == 4) return device_cmyk();
  throw_unfit_space();
}

ColorSpace ColorSpace::separation(const std::vector<std::string>& names,
                                  const ColorSpace& alternate, const Function& tint) {
  // Special spaces are no alternates (ISO 32000-1, 8.6.6.4), so spaces never lie deep.
  if (alternate.is_separation_ || names.size() != static_cast<std::size_t>(tint.inputs()) ||
      tint.outputs() < alternate.components())
    throw_unfit_space();
  ColorSpace space(
      std::vector<ValueRange>(names.size()),
      [alternate, tint](std::span<const double> c) { return alternate.to_srgb(tint(c)); });
  space.is_separation_ = true;
  space.paints_ =
      !std::ranges::all_of(names, [](const std::string& name) { return name == "None"; });
  return space;
}

glm::dvec3 ColorSpace::to_srgb(std::span<const double> components) const {
  std::array<double, max_function_values> within{};
  for (std::size_t i = 0; i < ranges_.size(); ++i)
    within[i] = i < components.size() ? clipped(components[i], ranges_[i]) : ranges_[i].low;
  return glm::clamp(conversion_(std::span(within).first(ranges_.size())), 0.0, 1.0);
}

}  // namespace gradmesh
