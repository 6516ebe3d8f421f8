#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gradmesh {

/// Returns the bytes as text (RFC 4648, section 4).
std::string base64(std::string_view bytes);

/// Returns the bytes of such a text, or nothing if it is none.
std::optional<std::string> base64_bytes(std::string_view text);

}  // namespace gradmesh
