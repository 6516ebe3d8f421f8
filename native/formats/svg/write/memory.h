#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "form/blocks.h"
#include "mesh/mesh.h"
#include "mesh/parts.h"

namespace gradmesh {

/// A mesh that an element remembers, as the value of an attribute: bytes compressed by zlib (RFC
/// 1950), in base64. In the colour model `bilinear` the bytes are packed patches
/// (formats/packed/patches.h) after a line with a letter and the curves
/// (formats/svg/read/curves.h); the letter is `p`, or `s` for a mesh that is smooth. In `bicubic`
/// they are a .hemesh file. Older versions have written an SVG document with a group of blocks,
/// which can still be recalled.

/// Returns the memory of the mesh, rounded to 2^-18 of its width and height; its faces lie over one
/// another as `overlaps` says. Returns an empty string if it is too large for an attribute.
std::string remember(const Mesh& mesh, const std::vector<Overlap>& overlaps = {});

/// Returns the memory of the blocks of a mesh that is written in this form, without its curves.
/// Returns an empty string if it is too large for an attribute.
std::string remember_blocks(const Mesh& mesh, const BlockForm& form);

/// Returns the mesh that an attribute holds, which can be built; nothing if the attribute is
/// damaged.
std::optional<MeshParts> recall(std::string_view memory);

/// Returns the blocks that an attribute holds; nothing if it is damaged.
std::optional<std::vector<PatchGrid>> recall_blocks(std::string_view memory);

}  // namespace gradmesh
