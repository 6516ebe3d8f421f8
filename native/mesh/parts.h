#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geom/patch.h"

namespace gradmesh {

/// How colour is held (README, "Two colour models"): `bilinear` knows four corner colours a
/// patch (SVG), `bicubic` has colour tangents and twists as well (the paper).
enum class ColorModel { bilinear, bicubic };

/// The half-edges along one side of a curve, in this side's own direction. Half-edge
/// 4 * patch + side is side `side` of that patch. More than one half-edge: the side is divided
/// at `breaks` (in this side's parameter, rising, one fewer than the half-edges).
struct CurveSide {
  std::vector<int> halfedges;
  std::vector<double> breaks;

  bool operator==(const CurveSide&) const = default;
};

/// A curve with patches on both sides; `b` runs against `a`.
struct CurveParts {
  CurveSide a, b;
  /// Tangents of the whole curve at the start of `a` and of `b`, both into the curve. Where they
  /// are not given they follow from the patches, up to rounding where both sides are divided.
  std::optional<std::array<Value, 2>> tangents = std::nullopt;

  bool operator==(const CurveParts&) const = default;
};

/// What a reader knows of a mesh: its patches and which of their sides lie on one curve.
/// A patch side that no curve names is on the boundary.
struct MeshParts {
  std::vector<Patch> patches;
  std::vector<CurveParts> curves;
  ColorModel color_model = ColorModel::bilinear;
  /// Half-edges at T-junctions that keep their colour even where it looks like the parent's.
  std::vector<int> own_colors = {};
  /// As of Mesh::is_smooth.
  bool smooth = false;
};

/// The parts under an affine map of their positions.
void transform(MeshParts& parts, const Affine& affine);

/// Curves of a plain grid of `rows` x `columns` patches stored row by row.
std::vector<CurveParts> grid_curves(int rows, int columns);

}  // namespace gradmesh
