#include "files/orientation.h"

#include <cstdint>

namespace gradmesh {
namespace {

using namespace std::string_view_literals;

constexpr std::uint32_t orientation_tag = 0x0112, short_type = 3;
constexpr std::size_t entry_size = 12;

/// The numbers of a TIFF structure; beyond its end they are 0.
struct Tiff {
  std::string_view bytes;
  bool is_little_endian;

  std::uint32_t number(std::size_t at, std::size_t size) const {
    if (at > bytes.size() || bytes.size() - at < size) return 0;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
      value = value << 8 | std::uint8_t(bytes[at + (is_little_endian ? size - 1 - i : i)]);
    return value;
  }
};

}  // namespace

int exif_orientation(std::string_view exif) {
  if (exif.starts_with("Exif\0\0"sv)) exif.remove_prefix(6);
  const bool is_little_endian = exif.starts_with("II*\0"sv);
  if (!is_little_endian && !exif.starts_with("MM\0*"sv)) return 1;
  const Tiff tiff{exif, is_little_endian};
  const std::size_t directory = tiff.number(4, 4);
  const std::size_t entries = tiff.number(directory, 2);
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t entry = directory + 2 + i * entry_size;
    if (tiff.number(entry, 2) != orientation_tag || tiff.number(entry + 2, 2) != short_type)
      continue;
    const std::uint32_t value = tiff.number(entry + 8, 2);
    return value >= 1 && value <= 8 ? int(value) : 1;
  }
  return 1;
}

RgbaImage upright(const RgbaImage& image, int orientation) {
  const int w = image.width, h = image.height;
  RgbaImage turned = lies_on_its_side(orientation) ? RgbaImage(h, w) : RgbaImage(w, h);
  const auto source = [&](int x, int y) {
    switch (orientation) {
      case 2:
        return image.pixel(w - 1 - x, y);
      case 3:
        return image.pixel(w - 1 - x, h - 1 - y);
      case 4:
        return image.pixel(x, h - 1 - y);
      case 5:
        return image.pixel(y, x);
      case 6:
        return image.pixel(y, h - 1 - x);
      case 7:
        return image.pixel(w - 1 - y, h - 1 - x);
      case 8:
        return image.pixel(w - 1 - y, x);
      default:
        return image.pixel(x, y);
    }
  };
  for (int y = 0; y < turned.height; ++y)
    for (int x = 0; x < turned.width; ++x) turned.set_pixel(x, y, source(x, y));
  return turned;
}

}  // namespace gradmesh
