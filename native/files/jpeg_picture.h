#pragma once

#include <optional>
#include <string_view>

#include "base/message.h"
#include "files/picture_sink.h"

namespace gradmesh {

/// Whether a file begins as JPEG files do.
bool is_jpeg(std::string_view bytes);

/// Gives the picture of a JPEG file to the sink. Returns what is wrong with it, or nothing.
std::optional<Message> decode_jpeg(std::string_view bytes, PictureSink& sink);

}  // namespace gradmesh
