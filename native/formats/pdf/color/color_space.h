#pragma once

#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "formats/pdf/color/function.h"

namespace gradmesh {

/// Parameters of CalRGB (ISO 32000-1, 8.6.5.3) but BlackPoint, which readers ignore.
struct CalRgbParameters {
  /// (X, Y, Z), all positive.
  glm::dvec3 white_point{0.9505, 1, 1.089};
  glm::dvec3 gamma{1.0};
  /// Linear (A, B, C) to (X, Y, Z): its columns are the first, middle and last three numbers of
  /// Matrix.
  glm::dmat3 matrix{1.0};
};

/// Parameters of Lab (ISO 32000-1, 8.6.5.4) but BlackPoint, which readers ignore.
struct LabParameters {
  /// (X, Y, Z), all positive.
  glm::dvec3 white_point{0.9505, 1, 1.089};
  ValueRange a_range{-100, 100};
  ValueRange b_range{-100, 100};
};

/// A colour space of a PDF (ISO 32000-1, 8.6), which maps components to sRGB. It is immutable and
/// may be used from several threads.
///
/// The functions that make one throw an InputError if parameters do not fit together. Indexed and
/// Pattern are not among them: colours of the one are no numbers between which a mesh could blend,
/// and a shading cannot have the other.
class ColorSpace {
 public:
  static ColorSpace device_gray();
  static ColorSpace device_rgb();
  /// Colours as poppler shows them, which is without a profile.
  static ColorSpace device_cmyk();
  /// CalGray (ISO 32000-1, 8.6.5.2). Its white is that of the screen, so its WhitePoint is not
  /// needed.
  static ColorSpace cal_gray(double gamma);
  static ColorSpace cal_rgb(const CalRgbParameters& parameters);
  static ColorSpace lab(const LabParameters& parameters);
  /// ICCBased (ISO 32000-1, 8.6.5.5). The profile is not read: the space counts as the device space
  /// with 1, 3 or 4 components.
  static ColorSpace icc_based(int components);
  /// Separation, with one name, and DeviceN (ISO 32000-1, 8.6.6.4 and 8.6.6.5). A screen has none
  /// of these colorants, not even `All` of them, so `tint` always maps components to `alternate`.
  static ColorSpace separation(const std::vector<std::string>& names, const ColorSpace& alternate,
                               const Function& tint);

  int components() const { return static_cast<int>(ranges_.size()); }
  /// Returns the least and the greatest value of each component, which is the default of Decode.
  const std::vector<ValueRange>& ranges() const { return ranges_; }
  /// Returns false if nothing is seen of what has these colours: all colorants are `None`.
  bool paints() const { return paints_; }

  /// Returns (r, g, b), 0..1, sRGB. Components are clipped to `ranges()`; those that are missing or
  /// no numbers count as the least, and those in excess are ignored.
  glm::dvec3 to_srgb(std::span<const double> components) const;

 private:
  /// Maps as many components as there are, within their ranges.
  using Conversion = std::function<glm::dvec3(std::span<const double>)>;

  ColorSpace(std::vector<ValueRange> ranges, Conversion conversion)
      : ranges_(std::move(ranges)), conversion_(std::move(conversion)) {}

  std::vector<ValueRange> ranges_;
  Conversion conversion_;
  bool is_separation_ = false;
  bool paints_ = true;
};

}  // namespace gradmesh
