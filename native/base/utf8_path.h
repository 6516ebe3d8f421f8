#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace gradmesh {

/// Returns the path that a text in UTF-8 names. A path that is made of a text itself takes that to
/// be in the system's code page on Windows.
inline std::filesystem::path utf8_path(std::string_view text) {
  return std::u8string(text.begin(), text.end());
}

}  // namespace gradmesh
