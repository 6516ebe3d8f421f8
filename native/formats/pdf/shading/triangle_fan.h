#pragma once

#include <array>
#include <optional>
#include <span>

#include "formats/pdf/shading/packing.h"
#include "formats/pdf/shading/read_triangles.h"

namespace gradmesh {

/// A cell of four triangles around a point in its middle, as matplotlib writes those of a lattice.
struct TriangleFan {
  /// One after the other around the cell.
  std::array<ShadingVertex, 4> corners;
  ShadingVertex middle;
};

/// Returns the cell that four triangles make, in the order of the first; nothing if they are none.
std::optional<TriangleFan> fan_of(std::span<const ShadingTriangle, 4> triangles);

/// Returns true if the bilinear patch with these corners covers what the triangles do, and has
/// their colours but for 4 levels of 255 of what a component may be.
bool is_bilinear(const TriangleFan& fan, const std::vector<Packing::Range>& components);

}  // namespace gradmesh
