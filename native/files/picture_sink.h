#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace gradmesh {

/// How the samples of a picture without a profile become colours: a power, and the chromaticities
/// of white and the primaries. By default sRGB's.
struct PictureEncoding {
  struct Chromaticity {
    double x, y;
    bool operator==(const Chromaticity&) const = default;
  };

  double gamma = 0;  ///< the exponent that makes light of a sample, or 0 for the curve of sRGB
  Chromaticity white{0.3127, 0.3290}, red{0.64, 0.33}, green{0.30, 0.60}, blue{0.15, 0.06};

  bool operator==(const PictureEncoding&) const = default;
};

/// What a decoder tells of a picture before its rows.
struct PictureForm {
  int width = 0, height = 0;
  int colors =
      3;         ///< samples of a pixel beside its opacity: grey, RGB, or CMYK (full ink is 65535)
  int bits = 8;  ///< of a sample in the file, 8 or 16: with 8 bits all samples are v * 257
  std::string_view profile = {};  ///< the ICC profile of the samples; empty where there is none
  PictureEncoding encoding = {};  ///< where there is no profile
};

/// What takes a picture from a decoder, row by row. Nothing here throws: decoders are C, or
/// modules.
class PictureSink {
 public:
  virtual ~PictureSink() = default;

  /// Begins a picture. False where it is refused; then the decoder ends without an error.
  virtual bool begin(const PictureForm& form) noexcept = 0;
  /// Takes the next row, from the top: of each pixel the colours and the opacity, by which the
  /// colours are not multiplied.
  virtual void row(const std::uint16_t* samples) noexcept = 0;
  /// Says how the picture is to be turned, as EXIF does (1 to 8). This may be said at any time.
  virtual void turn(int orientation) noexcept = 0;
};

}  // namespace gradmesh
