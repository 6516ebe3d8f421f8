#include "ops/split/split_line.h"

#include <cmath>
#include <string>

#include "base/error.h"
#include "mesh/subdivide.h"
#include "ops/split/split.h"

namespace gradmesh {
namespace {

/// A point on a whole side of a curve.
struct Place {
  /// The curve side; invalid beyond the boundary.
  Halfedge side;
  double t = 0;
};

/// Returns the point t of a leaf as a point of the other side of its curve.
Place beyond(const Mesh& mesh, Halfedge leaf, double t) {
  const Interval span = mesh.span(leaf);
  return {mesh.other_side(leaf), 1 - std::lerp(span.first, span.second, t)};
}

/// Returns the leaf in which the point lies, and the point's place on it; invalid where patches
/// already meet there.
Place leaf_at(const Mesh& mesh, const Place& place) {
  if (!place.side.valid()) return {};
  for (const Halfedge leaf : mesh.leaves(place.side)) {
    const Interval span = mesh.span(leaf);
    if (std::abs(place.t - span.first) <= same_place) return {};
    if (place.t < span.second - same_place) return {leaf, (place.t - span.first) / span.length()};
  }
  return {};
}

/// Returns a point where patches meet on one side of a curve only, as a leaf and a place on the
/// curve's other side; invalid where there is none.
Place open_junction(const Mesh& mesh) {
  for (const Halfedge side : mesh.halfedges()) {
    if (!mesh.is_parent(side) || !mesh[side].twin.valid()) continue;
    for (const Halfedge leaf : mesh.leaves(side)) {
      const double t = mesh.span(leaf).first;
      if (t == 0) continue;
      const Place opposite = leaf_at(mesh, {mesh[side].twin, 1 - t});
      if (opposite.side.valid()) return opposite;
    }
  }
  return {};
}

}  // namespace

void split_line(Journal& journal, Halfedge side, double t) {
  const Mesh& mesh = journal.mesh();
  for (Place at{side, t}; at.side.valid();) {
    const Place across = beyond(mesh, mesh.next(mesh.next(at.side)), 1 - at.t);
    split(journal, at.side, at.t);
    at = leaf_at(mesh, across);
  }
}

void split_line_across(Journal& journal, Halfedge side, double t) {
  const Mesh& mesh = journal.mesh();
  const Place behind = beyond(mesh, side, t);
  split_line(journal, side, t);
  const Place at = leaf_at(mesh, behind);
  if (at.side.valid()) split_line(journal, at.side, at.t);
}

void extend_stems(Journal& journal, int most_patches) {
  const Mesh& mesh = journal.mesh();
  for (Place at = open_junction(mesh); at.side.valid(); at = open_junction(mesh)) {
    split_line(journal, at.side, at.t);
    if (mesh.face_count() > most_patches)
      throw InputError(
          "its T-junctions are so many that one mesh would have more than {0} patches.",
          most_patches);
  }
}

}  // namespace gradmesh
