#pragma once

#include <string>
#include <string_view>

namespace gradmesh {

/// Returns input as a message shows it: in double quotes, with blanks and control characters as one
/// blank, cut when long.
std::string excerpt(std::string_view text);

}  // namespace gradmesh
