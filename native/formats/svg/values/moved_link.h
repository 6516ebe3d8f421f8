#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace gradmesh {

/// A document that was read from a file and is written into another folder. Both paths are absolute
/// and without `..`.
struct FolderMove {
  std::filesystem::path file, folder;
};

/// Returns what a link of the document becomes, so that it leads to the same file from the new
/// folder; nothing if it stays as it is: `#id`, an absolute one, and one with a scheme such as
/// `data:`, for which the letter of a drive is taken too. A link to an element of the document by
/// the name of its own file becomes `#id`, as the new file may have another name. What is added is
/// percent-encoded, so that it can stand wherever the link stood; what is left of the link is
/// spelled as it was. It does not matter whether there is such a file.
std::optional<std::string> moved_link(std::string_view link, const FolderMove& move);

}  // namespace gradmesh
