#pragma once

#include <string>

#include "base/image.h"

namespace gradmesh {

/// What the module `gradmesh_images` offers to image_module.cpp. Both functions return what is
/// wrong, in one line, or nothing: errors do not cross the border of a module as exceptions.
struct ImageCodec {
  /// Any file that OpenImageIO reads, as read_image gives it.
  std::string (*read)(const std::string& path, Image& image);
  /// `bytes` becomes a PNG file. The image has pixels.
  std::string (*encode_png)(const Image& image, std::string& bytes);
};

}  // namespace gradmesh

#ifdef _WIN32
#define GRADMESH_MODULE_EXPORT __declspec(dllexport)
#else
#define GRADMESH_MODULE_EXPORT __attribute__((visibility("default")))
#endif

/// The one symbol of the module.
extern "C" GRADMESH_MODULE_EXPORT const gradmesh::ImageCodec gradmesh_image_codec;
