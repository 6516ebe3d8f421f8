// Whatever a picture is, what is read of it keeps to the size that was asked for.
#include <zlib.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "files/orientation.h"
#include "files/picture_file.h"
#include "files/picture_reducer.h"
#include "files/png_picture.h"
#include "target.h"

namespace gradmesh::fuzz {
namespace {

/// A million pixels, however large a file says that it is. Windows has no setenv.
char limits[] = "GRADMESH_LIMITS=memory=8M";
[[maybe_unused]] const int limited = putenv(limits);

constexpr int longest = 16;
constexpr std::size_t signature_size = 8, name_size = 4, sum_size = 4;

void check_picture(std::string_view bytes) {
  accepts([&] {
    const Picture picture = picture_of_bytes(bytes, input_name, longest);
    const RgbaImage& image = picture.image;
    require(image.width >= 1 && image.height >= 1, "a picture has pixels");
    require(image.width <= longest && image.height <= longest, "a picture keeps to its size");
    require(image.width <= picture.full_width && image.height <= picture.full_height,
            "a picture is never enlarged");
  });
}

std::uint32_t number(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::uint8_t(bytes[i]);
  return value;
}

/// The PNG file with the right checksums, which no fuzzer finds.
std::string with_checksums(std::string png) {
  std::size_t at = signature_size;
  while (png.size() - at >= 4 + name_size + sum_size) {
    const std::size_t size = number(std::string_view(png).substr(at));
    if (size > png.size() - at - 4 - name_size - sum_size) break;
    at += 4;
    const auto sum = std::uint32_t(
        crc32(0, reinterpret_cast<const Bytef*>(png.data() + at), uInt(name_size + size)));
    at += name_size + size;
    for (int shift = 24; shift >= 0; shift -= 8) png[at++] = char(sum >> shift & 255);
  }
  return png;
}

/// The bytes as a profile for pictures of so many colours and bits.
void check_profile(std::string_view bytes, int colors, int bits) {
  PictureReducer sink(longest);
  PictureForm form;
  form.width = 2, form.height = 1;
  form.colors = colors, form.bits = bits, form.profile = bytes;
  if (!sink.begin(form)) return;
  std::vector<std::uint16_t> row(2 * std::size_t(colors + 1), 0x8080);
  row[0] = 0;
  sink.row(row.data());
  require(!sink.wrong(), "a picture is whole");
  require(sink.picture().image.width == 2, "a picture keeps its size");
}

}  // namespace

void check(std::string_view bytes) {
  check_picture(bytes);
  if (is_png(bytes)) check_picture(with_checksums(std::string(bytes)));
  const int orientation = exif_orientation(bytes);
  require(orientation >= 1 && orientation <= 8, "EXIF has eight orientations");
  for (const int colors : {1, 3, 4})
    for (const int bits : {8, 16}) check_profile(bytes, colors, bits);
}

}  // namespace gradmesh::fuzz
