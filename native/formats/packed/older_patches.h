#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "mesh/parts.h"

namespace gradmesh {

/// Returns rectangles of patches that were packed in lists of bytes, as they were remembered before
/// the steps of the original were: nothing if the bytes are damaged, hold more patches than the
/// limit (base/limits.h), or lie beyond 1e9.
std::optional<std::vector<PatchGrid>> unpack_older_patches(std::string_view bytes);

}  // namespace gradmesh
