#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/parts.h"

namespace gradmesh {

/// Rectangles of patches of the colour model `bilinear` in few bytes, a tenth of what they take as
/// text, and less once zlib has compressed them: numbers are differences from what their neighbours
/// lead to expect.
///   - x and y are rounded to a power of two that is at most 2^-precision of the width or height of
///     all patches.
///   - Sides straight to within such a step are lines, and patches that are Coons patches to within
///     one become such patches.
///   - Colours are rounded to 8 bits if all of a channel are such numbers, otherwise to 16.
std::string pack_patches(std::vector<PatchGrid> grids, int precision);

/// Returns the patches; nothing if the bytes are damaged, hold more patches than the limit
/// (base/limits.h), or lie beyond 1e9.
std::optional<std::vector<PatchGrid>> unpack_patches(std::string_view bytes);

}  // namespace gradmesh
