#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/parts.h"

namespace gradmesh {

/// A mesh of the colour model `bilinear` as rectangles of patches.
struct PackedMesh {
  /// The value of Mesh::is_smooth().
  bool smooth = false;
  /// The curves with more than one rectangle along them (formats/svg/values/curves.h).
  std::string curves = {};
  std::vector<PatchGrid> grids = {};
};

/// Returns the mesh in few bytes, a fifteenth of what it takes as text: whole numbers of a step
/// (formats/packed/scale.h, which `precision` is for), as they differ from what their neighbours
/// lead to expect, each in as many bits as its kind needs on average. Nothing compresses them
/// further.
std::string pack(PackedMesh mesh, int precision);

/// Returns the mesh; nothing if the bytes are damaged, as far as that shows, hold more patches than
/// the limit (base/limits.h), or lie beyond 1e9.
std::optional<PackedMesh> unpack(std::string_view bytes);

}  // namespace gradmesh
