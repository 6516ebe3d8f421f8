#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace gradmesh {

/// Bytes compressed by zlib (RFC 1950), with its checksum.
std::string zip(std::string_view bytes);

/// The bytes again; nothing where they are damaged or more than `most`.
std::optional<std::string> unzip(std::string_view zipped, std::size_t most);

}  // namespace gradmesh
