#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "form/blocks.h"
#include "formats/svg/tree/objects.h"
#include "mesh/mesh.h"
#include "mesh/parts.h"

namespace gradmesh {

/// A mesh that an element remembers, as the value of an attribute. In the colour model `bilinear`
/// it is a tilde and, in base85, the packed mesh (formats/packed/patches.h) and 32 bits of its
/// hash. In `bicubic` it is a .hemesh file compressed by zlib (RFC 1950), in base64. gradmesh 0.1
/// has so compressed an SVG document with a group of blocks, which can still be recalled.

/// Returns the memory of the mesh, whose faces lie over one another as `overlaps` says. Numbers
/// that have a decimal step, as those of most documents, are remembered exactly, others to 2^-22 of
/// the mesh's width and height. Returns an empty string if it is too large for an attribute.
std::string remember(const Mesh& mesh, const std::vector<Overlap>& overlaps = {});

/// Returns the memory of the blocks of a mesh that is written in this form, without its curves.
/// Returns an empty string if it is too large for an attribute.
std::string remember_blocks(const Mesh& mesh, const BlockForm& form);

/// Returns the mesh that an attribute holds, which can be built; nothing if the attribute is
/// damaged.
std::optional<MeshParts> recall(std::string_view memory);

/// Returns the blocks that an attribute holds; nothing if it is damaged.
std::optional<std::vector<PatchGrid>> recall_blocks(std::string_view memory);

/// Returns the memory of an object's mesh before it was first simplified; nothing if there is none.
std::optional<std::string> memory_of(const MeshObject& object);
/// Returns that mesh in the coordinates of the object's mesh, which can be built; nothing if there
/// is none, or the memory is damaged.
std::optional<MeshParts> recalled_mesh(const SvgTree& tree, const MeshObject& object);

}  // namespace gradmesh
