#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "formats/svg/values/moved_link.h"

namespace gradmesh {

/// Returns what a style sheet, or a value or declarations of one, become, so that the files that
/// they name by `url(…)` or `@import` are the same from the new folder; nothing if all stays. What
/// stands in comments and in other strings stays.
std::optional<std::string> moved_css(std::string_view css, const FolderMove& move);

}  // namespace gradmesh
