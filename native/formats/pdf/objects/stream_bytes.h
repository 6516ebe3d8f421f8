#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "formats/pdf/objects/qpdf.h"

namespace gradmesh {

/// What a stream holds once it is unpacked.
struct StreamBytes {
  std::string bytes;
  /// Whether it could not be unpacked to its end, as it is damaged.
  bool is_damaged = false;
};

/// Returns what a stream holds. Throws InputError if that is more than the limit of documents.
StreamBytes stream_bytes(QPDFObjectHandle stream);

/// Returns what was packed by zlib's deflate, likewise.
StreamBytes inflated_bytes(std::string_view packed);

/// Returns what the first frame of Zstandard (RFC 8878) holds, likewise; what follows it says
/// nothing.
StreamBytes zstandard_bytes(std::string_view packed);

}  // namespace gradmesh
