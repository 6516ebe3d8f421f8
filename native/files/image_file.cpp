#include "files/image_file.h"

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/image_module.h"
#include "files/png_image.h"

namespace gradmesh {

Image read_image(const std::filesystem::path& path) {
  Image image;
  const std::string wrong = image_codec().read(path.string(), image);
  if (!wrong.empty()) throw InputError("{0} is not a readable image: {1}.", path.string(), wrong);
  return image;
}

namespace {

template <int Channels>
std::string encoded(const Raster<std::uint8_t, Channels>& image) {
  if (image.width <= 0 || image.height <= 0) throw InputError("the image is empty.");
  PngImage png;
  png.image.width = png_uint_32(image.width);
  png.image.height = png_uint_32(image.height);
  png.image.format = Channels == 4 ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  const std::vector<std::uint8_t> samples = interleaved(image);
  png_alloc_size_t size = 0;
  std::string bytes;
  bool done = png_image_write_get_memory_size(png.image, size, 0, samples.data(), 0, nullptr);
  if (done) {
    bytes.resize(size);
    done =
        png_image_write_to_memory(&png.image, bytes.data(), &size, 0, samples.data(), 0, nullptr);
  }
  if (!done) throw InputError("{0}.", png.image.message);
  bytes.resize(size);
  return bytes;
}

}  // namespace

std::string png_bytes(const Image& image) { return encoded(image); }
std::string png_bytes(const RgbaImage& image) { return encoded(image); }

void write_png(const Image& image, const std::filesystem::path& path) {
  std::string bytes;
  try {
    bytes = png_bytes(image);
  } catch (const InputError& error) {
    throw InputError("{0} cannot be written: {1}", path.string(), error.message());
  }
  write_bytes(path, bytes);
}

}  // namespace gradmesh
