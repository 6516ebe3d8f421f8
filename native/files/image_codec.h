#pragma once

#include <cstdint>
#include <string>

#include "base/image.h"

namespace gradmesh {

/// The function that the module `gradmesh_images` offers to image_module.cpp.
struct ImageCodec {
  /// Reads any file that OpenImageIO reads, as read_image does. Returns the error in one line, or
  /// an empty string: errors do not cross the border of a module as exceptions.
  std::string (*read)(const std::string& path, Image& image);
};

/// Returns the sample laid over white with this alpha, rounded; both are 0..255. Pictures with
/// transparency are read so.
inline std::uint8_t over_white(int sample, int alpha) {
  return std::uint8_t((sample * alpha + 255 * (255 - alpha) + 127) / 255);
}

}  // namespace gradmesh

#ifdef _WIN32
#define GRADMESH_MODULE_EXPORT __declspec(dllexport)
#else
#define GRADMESH_MODULE_EXPORT __attribute__((visibility("default")))
#endif

/// The one symbol of the module.
extern "C" GRADMESH_MODULE_EXPORT const gradmesh::ImageCodec gradmesh_image_codec;
