#pragma once

#include <filesystem>
#include <optional>

#include "formats/svg/values/moved_link.h"

namespace gradmesh {

/// Returns how a document that was read from the file `from` comes into the file `to`; nothing if
/// it stays in its folder, and if the folder of one of them is not known, as that of /dev/stdin.
std::optional<FolderMove> folder_move(const std::filesystem::path& from,
                                      const std::filesystem::path& to);

}  // namespace gradmesh
