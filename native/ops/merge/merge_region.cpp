#include "ops/merge/merge_region.h"

#include <algorithm>

#include "ops/merge/merge.h"

namespace gradmesh {
namespace {

/// Returns a curve that depends on this one, directly or not, through the starts of stems, and has
/// no stems itself; the curve itself where it has none. Returns an invalid half-edge where one of
/// these curves is on the boundary.
Halfedge last_hanging(const Mesh& mesh, Halfedge side) {
  const Halfedge twin = mesh[side].twin;
  if (!twin.valid()) return {};
  for (const Halfedge divided : {side, twin})
    if (mesh.is_parent(divided)) return last_hanging(mesh, *mesh.stems(divided).begin());
  return side;
}

}  // namespace

bool grow(Journal& journal, Face face, int side) {
  const Mesh& mesh = journal.mesh();
  for (bool done = false; !done;) {
    // Recomputed each time, as merges join curves.
    const Halfedge across = mesh.curve_side(mesh.sides(face)[std::size_t(side % 4)]);
    const Halfedge edge = last_hanging(mesh, across);
    if (!edge.valid() || can_merge(mesh, edge) != MergeObstacle::none) return false;
    done = edge == across;
    const Halfedge twin = mesh[edge].twin;
    merge(journal, mesh.face(twin) == face ? twin : edge);
  }
  return true;
}

Region merging_view(const Mesh& mesh, const Region& region) {
  if (region.columns >= region.rows) return region;
  const std::vector<Halfedge> tops = region_tops(mesh, region);
  return tops.empty() ? region : region_views(mesh, region, tops)[1];
}

Face RegionMerger::merge(const Region& region) {
  const Region view = merging_view(start_, region);
  const bool grows =
      view.face == view_.face && view.top == view_.top && view.columns == view_.columns;
  keep_rows(grows ? view.rows : 0);
  view_ = view;
  while (int(depths_.size()) <= view.rows)
    if (!merge_row()) {
      undo();
      return {};
    }
  return view.face;
}

/// Merges the next row along itself and then with the rows above. Returns false, with the row as it
/// was, if a merge cannot be made.
bool RegionMerger::merge_row() {
  const std::size_t depth = journal_.depth();
  bool merged = true;
  if (depths_.size() == 1) {
    for (int j = 1; merged && j < view_.columns; ++j)
      merged = grow(journal_, view_.face, view_.top + 1);
  } else {
    merged = grow(journal_, view_.face, view_.top + 2);
  }
  merged ? depths_.push_back(journal_.depth()) : journal_.undo_to(depth);
  return merged;
}

void RegionMerger::keep_rows(int rows) {
  depths_.resize(std::min(depths_.size(), std::size_t(rows) + 1));
  journal_.undo_to(depths_.back());
}

}  // namespace gradmesh
