#pragma once

#include <png.h>

namespace gradmesh {

/// A picture while libpng works on it.
class PngImage {
 public:
  PngImage() { image.version = PNG_IMAGE_VERSION; }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
  ~PngImage() { png_image_free(&image); }

  png_image image{};
};

}  // namespace gradmesh
