#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace gradmesh {

/// Returns all bytes of a file. Throws InputError naming the file, also where the file is beyond
/// the limit on documents.
std::string read_bytes(const std::filesystem::path& path);

/// Writes `bytes` into the file, wholly or not at all: they are written to a new file in the same
/// folder, brought to the disk and renamed over `path`. The file keeps its permissions. Throws
/// InputError naming the file.
void write_bytes(const std::filesystem::path& path, std::string_view bytes);

}  // namespace gradmesh
