#pragma once

#include "geom/patch.h"
#include "mesh/parts.h"

namespace gradmesh::test {

/// Calls `change` for the values at the corners of all patches, between which colours are bilinear
/// then.
inline void change_corners(MeshParts& parts, const auto& change) {
  for (Patch& patch : parts.patches) {
    for (const int i : {0, 3})
      for (const int j : {0, 3}) change(patch.c[i][j]);
    make_color_bilinear(patch);
  }
}

}  // namespace gradmesh::test
