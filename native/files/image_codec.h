#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/image.h"
#include "base/message.h"
#include "files/picture_sink.h"

namespace gradmesh {

/// The functions that the module `gradmesh_images` offers to image_module.cpp. Errors do not cross
/// the border of a module as exceptions.
struct ImageCodec {
  /// Reads any file that OpenImageIO reads, as read_image does. Returns the error in one line, or
  /// an empty string.
  std::string (*read)(const std::string& path, Image& image);
  /// Gives the picture of any file that OpenImageIO reads to the sink. Returns what is wrong with
  /// the file, or nothing, also where the sink has refused it.
  std::optional<Message> (*read_picture)(const std::string& path, PictureSink& sink);
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
