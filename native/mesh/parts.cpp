#include "mesh/parts.h"

#include <utility>

namespace gradmesh {

void transform(MeshParts& parts, const Affine& affine) {
  for (Patch& patch : parts.patches) transform(patch, affine);
  for (CurveParts& curve : parts.curves)
    if (curve.tangents)
      for (Value& tangent : *curve.tangents) tangent.position = affine.vector(tangent.position);
}

void append(MeshParts& parts, const MeshParts& more) {
  const int first = 4 * int(parts.patches.size());
  for (const int patch : more.fixed) parts.fixed.push_back(patch + first / 4);
  parts.patches.insert(parts.patches.end(), more.patches.begin(), more.patches.end());
  for (CurveParts curve : more.curves) {
    for (CurveSide* side : {&curve.a, &curve.b})
      for (int& h : side->halfedges) h += first;
    parts.curves.push_back(std::move(curve));
  }
  for (const int h : more.own_colors) parts.own_colors.push_back(h + first);
}

std::vector<CurveParts> grid_curves(int rows, int columns) {
  const auto halfedge = [&](int row, int column, int side) {
    return 4 * (row * columns + column) + side;
  };
  std::vector<CurveParts> curves;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      if (column + 1 < columns)
        curves.push_back({{{halfedge(row, column, 1)}, {}}, {{halfedge(row, column + 1, 3)}, {}}});
      if (row + 1 < rows)
        curves.push_back({{{halfedge(row, column, 2)}, {}}, {{halfedge(row + 1, column, 0)}, {}}});
    }
  return curves;
}

MeshParts parts_of(const std::vector<PatchGrid>& grids, const std::vector<CurveParts>& between) {
  MeshParts parts;
  for (const PatchGrid& grid : grids)
    append(parts, {grid.patches, grid_curves(grid.rows, grid.columns)});
  parts.curves.insert(parts.curves.end(), between.begin(), between.end());
  return parts;
}

}  // namespace gradmesh
