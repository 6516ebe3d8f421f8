#include <png.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "base/limits.h"
#include "base/utf8_path.h"
#include "files/image_codec.h"
#include "files/image_module.h"

namespace gradmesh {
namespace {

/// A picture while libpng works on it.
class PngImage {
 public:
  PngImage() { image.version = PNG_IMAGE_VERSION; }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
  ~PngImage() { png_image_free(&image); }

  png_image image{};
};

std::string read(const std::string& path, Image& image) {
  std::ifstream file(utf8_path(path), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file) return "it cannot be read";
  PngImage png;
  if (!png_image_begin_read_from_memory(&png.image, bytes.data(), bytes.size()))
    return std::string("it is no PNG image, which is all that can be read here: ") +
           png.image.message;
  const std::uint64_t longer = std::max(png.image.width, png.image.height);
  if (const std::uint64_t most = limits().resolution; longer > most)
    return "it is " + std::to_string(longer) + " pixels long, " +
           beyond_limit("resolution", most, longer).english();
  png.image.format = PNG_FORMAT_RGBA;
  std::vector<std::uint8_t> samples(PNG_IMAGE_SIZE(png.image));
  if (!png_image_finish_read(&png.image, nullptr, samples.data(), 0, nullptr))
    return png.image.message;
  image = Image(int(png.image.width), int(png.image.height));
  for (std::size_t i = 0; i < image.pixels(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      image.samples[k * image.pixels() + i] = over_white(samples[4 * i + k], samples[4 * i + 3]);
  return {};
}

/// Those that are read here are read without a codec.
std::optional<Message> read_no_picture(const std::string&, PictureSink&) {
  return Message("it is neither PNG nor JPEG, which are all that can be read here");
}

}  // namespace

/// A program for other people's machines has no OpenImageIO: images are PNG alone, pictures PNG and
/// JPEG.
const ImageCodec& image_codec() {
  static const ImageCodec codec{read, read_no_picture};
  return codec;
}

}  // namespace gradmesh
