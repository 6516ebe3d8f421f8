#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace gradmesh {

/// Bytes compressed by zlib (RFC 1950), with its checksum.
std::string zip(std::string_view bytes);

/// The bytes again; nothing where they are damaged or more than `most`.
std::optional<std::string> unzip(std::string_view zipped, std::size_t most);

/// The same in the format of gzip (RFC 1952), as .svgz files have it: without a name or a time, so
/// that equal bytes have equal files.
std::string gzip(std::string_view bytes);
bool is_gzip(std::string_view bytes);
/// How many bytes a gzip file says it unpacks to, modulo 2^32.
std::uint64_t gunzipped_size(std::string_view bytes);
/// These bytes; nothing where the file is damaged or does not unpack to as many.
std::optional<std::string> gunzip(std::string_view bytes);

}  // namespace gradmesh
