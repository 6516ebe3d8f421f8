#include "files/image_file.h"

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/image_module.h"

namespace gradmesh {

Image read_image(const std::filesystem::path& path) {
  Image image;
  const std::string wrong = image_codec().read(path.string(), image);
  if (!wrong.empty()) throw InputError("{0} is not a readable image: {1}.", path.string(), wrong);
  return image;
}

std::string png_bytes(const Image& image) {
  if (image.width <= 0 || image.height <= 0) throw InputError("the image is empty.");
  std::string bytes;
  const std::string wrong = image_codec().encode_png(image, bytes);
  if (!wrong.empty()) throw InputError("{0}.", wrong);
  return bytes;
}

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
