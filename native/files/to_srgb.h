#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "files/picture_sink.h"

namespace gradmesh {

/// Brings a picture's rows to sRGB.
class ToSrgb {
 public:
  ToSrgb() = default;
  /// A profile that is damaged, or for other colours than the picture has, is ignored.
  explicit ToSrgb(const PictureForm& form);

  /// False for CMYK without a profile: nobody can say what colours these are.
  bool is_possible() const { return transform_ || colors_ < 4; }
  /// Converts a row as PictureSink has it to red, green, blue and opacity.
  void convert(const std::uint16_t* row, std::uint16_t* rgba) noexcept;

 private:
  struct Close {
    void operator()(void* transform) const;
  };

  void spread(const std::uint16_t* row, std::uint16_t* rgba) const noexcept;
  void transform(const std::uint16_t* row, std::uint16_t* rgba) noexcept;

  std::size_t width_ = 0;
  int colors_ = 3, profile_colors_ = 3, bits_ = 8;
  std::unique_ptr<void, Close> transform_;
  std::vector<std::uint8_t> narrow_, narrow_rgba_;  ///< a row in 8 bits, before and after
};

}  // namespace gradmesh
