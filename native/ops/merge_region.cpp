#include "ops/merge_region.h"

#include <algorithm>

#include "ops/merge.h"

namespace gradmesh {
namespace {

bool try_merge(Journal& journal, Halfedge edge) {
  if (can_merge(journal.mesh(), edge) != MergeObstacle::none) return false;
  merge(journal, edge);
  return true;
}

/// The half-edges that lead through a region while it is merged: they outlive all merges before
/// their own.
struct MergeOrder {
  int columns;
  /// The edges inside each row, row by row, and the left side of each row.
  std::vector<Halfedge> inside, left;
};

/// `mesh` as it is before the first merge; `view` as of merging_view.
MergeOrder merge_order(const Mesh& mesh, const Region& view, const std::vector<Halfedge>& tops) {
  MergeOrder order{view.columns, {}, {}};
  for (int i = 0; i < view.rows; ++i) {
    const auto row = tops.begin() + std::ptrdiff_t(i) * view.columns;
    for (int j = 0; j + 1 < view.columns; ++j) order.inside.push_back(mesh.next(row[j]));
    order.left.push_back(mesh.prev(row[0]));
  }
  return order;
}

/// Merges a row along itself and with the rows above, which are merged already.
bool merge_row(Journal& journal, const MergeOrder& order, int row) {
  const int inside = order.columns - 1;
  for (int j = 0; j < inside; ++j)
    if (!try_merge(journal, order.inside[row * inside + j])) return false;
  return row == 0 || try_merge(journal, journal.mesh().next(order.left[row]));
}

/// How many merges the first rows of a region take.
std::size_t merges(int rows, int columns) { return rows > 0 ? std::size_t(rows * columns - 1) : 0; }

void undo_to(Journal& journal, std::size_t depth) {
  while (journal.depth() > depth) journal.undo();
}

}  // namespace

Region merging_view(const Mesh& mesh, const Region& region, const std::vector<Halfedge>& tops) {
  return region.columns >= region.rows ? region : region_views(mesh, region, tops)[1];
}

bool merge_region(Journal& journal, const Region& region, const std::vector<Halfedge>& tops) {
  const Region view = merging_view(journal.mesh(), region, tops);
  const MergeOrder order =
      merge_order(journal.mesh(), view, view == region ? tops : region_tops(journal.mesh(), view));
  const std::size_t depth = journal.depth();
  for (int row = 0; row < view.rows; ++row)
    if (!merge_row(journal, order, row)) {
      undo_to(journal, depth);
      return false;
    }
  return true;
}

bool RegionMerger::merge(const Region& region) {
  std::vector<Halfedge> tops = region_tops(start_, region);
  if (tops.empty()) {
    undo();
    return false;
  }
  const Region view = merging_view(start_, region, tops);
  if (view != region) tops = region_tops(start_, view);
  const bool grows =
      view.face == view_.face && view.top == view_.top && view.columns == view_.columns;
  keep_rows(grows ? std::min(view.rows, view_.rows) : 0);
  const MergeOrder order = merge_order(start_, view, tops);
  for (int row = view_.rows; row < view.rows; ++row)
    if (!merge_row(journal_, order, row)) {
      undo();
      return false;
    }
  view_ = view;
  return true;
}

void RegionMerger::keep_rows(int rows) {
  view_.rows = rows;
  undo_to(journal_, depth_ + merges(rows, view_.columns));
}

}  // namespace gradmesh
