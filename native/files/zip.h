#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace gradmesh {

/// Returns the bytes compressed by zlib (RFC 1950), with its checksum.
std::string pack_zlib(std::string_view bytes);

/// Returns the uncompressed bytes, or nothing if they are damaged or more than `most`.
std::optional<std::string> unpack_zlib(std::string_view zipped, std::size_t most);

/// Returns the bytes compressed in the format of gzip (RFC 1952), as .svgz files have it. The
/// header has neither a name nor a time, so that equal bytes give equal files.
std::string gzip(std::string_view bytes);
bool is_gzip(std::string_view bytes);
/// Returns the size, modulo 2^32, that a gzip file states for its uncompressed bytes.
std::uint64_t gunzipped_size(std::string_view bytes);
/// Returns the uncompressed bytes, or nothing if the file is damaged or their number is not
/// gunzipped_size().
std::optional<std::string> gunzip(std::string_view bytes);

}  // namespace gradmesh
