#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geom/patch.h"

namespace gradmesh {

/// How a mesh holds colours (README, "Two colour models"): `bilinear` has four corner colours a
/// patch (SVG), `bicubic` has colour tangents and twists as well (the paper).
enum class ColorModel { bilinear, bicubic };

/// The half-edges along one side of a curve, in this side's own direction. Half-edge 4 * patch +
/// side is side `side` of that patch. A side of more than one half-edge is divided at `breaks` (in
/// this side's parameter, rising, one fewer than the half-edges).
struct CurveSide {
  std::vector<int> halfedges;
  std::vector<double> breaks;

  bool operator==(const CurveSide&) const = default;
};

/// A curve with patches on both sides; `b` runs against `a`.
struct CurveParts {
  CurveSide a, b;
  /// Tangents of the whole curve at the start of `a` and of `b`, both into the curve. Tangents that
  /// are not given follow from the patches, up to rounding where both sides are divided.
  std::optional<std::array<Value, 2>> tangents = std::nullopt;

  bool operator==(const CurveParts&) const = default;
};

/// A mesh as readers know it: its patches and which of their sides lie on one curve. A patch side
/// that no curve names is on the boundary.
struct MeshParts {
  std::vector<Patch> patches;
  std::vector<CurveParts> curves;
  ColorModel color_model = ColorModel::bilinear;
  /// Half-edges at T-junctions that keep their colour even where it looks like the parent's.
  std::vector<int> own_colors = {};
  /// The value of Mesh::is_smooth().
  bool smooth = false;
  /// The patches, by their numbers, of which nothing may change.
  std::vector<int> fixed = {};
};

/// A rectangle of patches without T-junctions, row by row: `rows * columns` of them, both at least
/// 1.
struct PatchGrid {
  int rows = 0, columns = 0;
  std::vector<Patch> patches;
};

/// Applies an affine map to the positions of the parts.
void transform(MeshParts& parts, const Affine& affine);

/// Adds the patches, curves and colours of `more` behind those of `parts`.
void append(MeshParts& parts, const MeshParts& more);

/// Returns the curves of a plain grid of `rows` x `columns` patches stored row by row.
std::vector<CurveParts> grid_curves(int rows, int columns);

/// Returns the patches of all grids in their order, and the curves inside each of them and then
/// those between them.
MeshParts parts_of(const std::vector<PatchGrid>& grids,
                   const std::vector<CurveParts>& between = {});

}  // namespace gradmesh
