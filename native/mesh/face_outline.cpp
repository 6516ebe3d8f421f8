#include "mesh/face_outline.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/clamped_int.h"
#include "geom/box.h"
#include "geom/fold.h"

namespace gradmesh {
namespace {

/// Returns into how many pieces a curve is cut so that chords are off by at most `flatness`.
int pieces_within(const Cubic<Value>& curve, double flatness) {
  constexpr int most = 64;
  const glm::dvec2 b0 = curve.p0.position, b1 = curve.bezier1().position;
  const glm::dvec2 b2 = curve.bezier2().position, b3 = curve.p1.position;
  const double bend = std::max(glm::length(b0 - 2.0 * b1 + b2), glm::length(b1 - 2.0 * b2 + b3));
  return clamped_int(std::ceil(std::sqrt(6 * bend / (8 * flatness))), 1, most);
}

}  // namespace

FilledOutline face_outline(const Mesh& mesh, Face face) {
  constexpr double off = 1e-3;
  if (const Patch patch = mesh.patch(face); folds(patch))
    return {covered_cells(patch), FillRule::nonzero};
  Box box;
  for (const Halfedge side : mesh.sides(face)) {
    const Cubic<Value> curve = mesh.side_of(side);
    box.add_cubic(curve.p0.position, curve.bezier1().position, curve.bezier2().position,
                  curve.p1.position);
  }
  const double flatness = std::max(off * glm::length(box.size()), 1e-300);
  std::vector<glm::dvec2> polygon;
  for (const Halfedge side : mesh.sides(face)) {
    const Cubic<Value> curve = mesh.side_of(side);
    const int pieces = pieces_within(curve, flatness);
    for (int i = 0; i < pieces; ++i) polygon.push_back(curve.at(double(i) / pieces).position);
  }
  return {{polygon}, FillRule::nonzero};
}

}  // namespace gradmesh
