#include "mesh/color_model.h"

#include <glm/common.hpp>

namespace gradmesh {
namespace {

/// Returns the difference of colour from the first to the last corner along a side of a curve.
glm::dvec4 color_change(const MeshParts& parts, const CurveSide& side) {
  const auto corner = [&](int halfedge, int offset) {
    return parts.patches[std::size_t(halfedge / 4)].corner((halfedge + offset) % 4).color;
  };
  return corner(side.halfedges.back(), 1) - corner(side.halfedges.front(), 0);
}

}  // namespace

MeshParts as_bilinear(MeshParts parts) {
  parts.color_model = ColorModel::bilinear;
  for (Patch& patch : parts.patches) {
    for (const std::size_t i : {0, 3})
      for (const std::size_t j : {0, 3})
        patch.c[i][j].color = glm::clamp(patch.c[i][j].color, 0.0, 1.0);
    make_color_bilinear(patch);
  }
  return parts;
}

MeshParts as_bicubic(MeshParts parts) {
  parts.color_model = ColorModel::bicubic;
  for (Patch& patch : parts.patches) make_color_bilinear(patch);
  for (CurveParts& curve : parts.curves) {
    if (!curve.tangents) continue;
    const glm::dvec4 change = 0.5 * (color_change(parts, curve.a) - color_change(parts, curve.b));
    (*curve.tangents)[0].color = change;
    (*curve.tangents)[1].color = -change;
  }
  return parts;
}

}  // namespace gradmesh
