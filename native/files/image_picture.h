#pragma once

#include <optional>
#include <string>

#include "base/message.h"
#include "files/picture_sink.h"

namespace gradmesh {

/// Gives the picture of any file that OpenImageIO reads to the sink, and throws nothing. Returns
/// what is wrong with the file, or nothing, also where the sink has refused it. A part of the
/// module `gradmesh_images`.
std::optional<Message> decode_with_openimageio(const std::string& path, PictureSink& sink);

}  // namespace gradmesh
