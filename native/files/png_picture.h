#pragma once

#include <optional>
#include <string_view>

#include "base/message.h"
#include "files/picture_sink.h"

namespace gradmesh {

/// Whether a file begins as PNG files do.
bool is_png(std::string_view bytes);

/// Gives the picture of a PNG file to the sink. Returns what is wrong with it, or nothing.
std::optional<Message> decode_png(std::string_view bytes, PictureSink& sink);

}  // namespace gradmesh
