#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "form/blocks.h"
#include "mesh/mesh.h"
#include "mesh/parts.h"

namespace gradmesh {

/// A mesh that a group of blocks remembers, as the value of an attribute: a small document of its
/// own, compressed (zlib, RFC 1950) and in base64. In the colour model `bilinear` that is an SVG
/// document with such a group (formats/svg/read/read_group.h), of gradients and nothing else, in
/// `bicubic` a .hemesh file.

/// Returns the memory of the mesh with all its digits; its faces lie over one another as `overlaps`
/// says. Returns an empty string if it is too large for an attribute.
std::string remember(const Mesh& mesh, const std::vector<Overlap>& overlaps = {});

/// Returns the memory of the mesh in just the numbers of a document in which it is written in this
/// form. Returns an empty string if it is too large for an attribute.
std::string remember_as_written(const Mesh& mesh, const BlockForm& form);

/// Returns the mesh that an attribute holds, which can be built; nothing if the attribute is
/// damaged.
std::optional<MeshParts> recall(std::string_view memory);

}  // namespace gradmesh
