#include "files/image_file.h"

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/image_module.h"
#include "files/png.h"

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
  return encode_png(image.width, image.height, Channels, interleaved(image).data());
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
