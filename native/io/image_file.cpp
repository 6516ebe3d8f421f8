#include "io/image_file.h"

#include <dlfcn.h>

#include "base/error.h"
#include "io/atomic_file.h"
#include "io/image_codec.h"

namespace gradmesh {
namespace {

/// Opens the module when it is first asked for: OpenImageIO brings hundreds of libraries, and
/// loading them takes longer than many a mesh.
const ImageCodec& codec() {
  static const ImageCodec& opened = []() -> const ImageCodec& {
    // Looked for in the RUNPATH of the program or library that this is linked into.
    void* module = dlopen("gradmesh_images.so", RTLD_LAZY | RTLD_LOCAL);
    void* symbol = module ? dlsym(module, "gradmesh_image_codec") : nullptr;
    if (!symbol)
      throw InputError(std::string("images can be neither read nor written here: ") + dlerror() +
                       ".");
    return *static_cast<const ImageCodec*>(symbol);
  }();
  return opened;
}

}  // namespace

Image read_image(const std::filesystem::path& path) {
  Image image;
  const std::string wrong = codec().read(path.string(), image);
  if (!wrong.empty()) throw InputError(path.string() + " is not a readable image: " + wrong + ".");
  return image;
}

std::string png_bytes(const Image& image) {
  if (image.width <= 0 || image.height <= 0) throw InputError("the image is empty.");
  std::string bytes;
  const std::string wrong = codec().encode_png(image, bytes);
  if (!wrong.empty()) throw InputError(wrong + ".");
  return bytes;
}

void write_png(const Image& image, const std::filesystem::path& path) {
  std::string bytes;
  try {
    bytes = png_bytes(image);
  } catch (const InputError& error) {
    throw InputError(path.string() + " cannot be written: " + error.what());
  }
  write_bytes(path, bytes);
}

}  // namespace gradmesh
