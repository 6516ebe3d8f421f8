#pragma once

#include <filesystem>
#include <optional>

#include "app/document/document.h"
#include "formats/svg/values/moved_link.h"

namespace gradmesh {

/// Throws InputError if the path's extension is that of another format.
void check_target(const Document& document, const std::filesystem::path& path);
/// Writes Document::bytes() into a file, compressed by gzip if the path's extension says so. In
/// another folder than that from which the document was read, links to files are such that they
/// lead to the same files. Throws as check_target does, and if the file cannot be written.
void write_file(const Document& document, const std::filesystem::path& path);

/// Returns how a document that was read from the file `from` comes into the file `to`; nothing if
/// it stays in its folder, and if the folder of one of them is not known, as that of /dev/stdin.
std::optional<FolderMove> folder_move(const std::filesystem::path& from,
                                      const std::filesystem::path& to);

}  // namespace gradmesh
