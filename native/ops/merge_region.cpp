#include "ops/merge_region.h"

#include "ops/merge.h"

namespace gradmesh {
namespace {

bool try_merge(Journal& journal, Halfedge edge) {
  if (can_merge(journal.mesh(), edge) != MergeObstacle::none) return false;
  merge(journal, edge);
  return true;
}

bool merge_rows(Journal& journal, const Region& region, const std::vector<Halfedge>& tops) {
  const Mesh& mesh = journal.mesh();
  // Sides across the rows, and the left ends of the rows, outlive the merges along the rows.
  std::vector<Halfedge> across, left;
  for (int i = 0; i < region.rows; ++i) {
    const auto row = tops.begin() + i * region.columns;
    for (int j = 0; j + 1 < region.columns; ++j) across.push_back(mesh.next(row[j]));
    left.push_back(mesh.prev(row[0]));
  }
  for (const Halfedge edge : across)
    if (!try_merge(journal, edge)) return false;
  for (int i = 0; i + 1 < region.rows; ++i) {
    // Each merge makes the patch reach down to the next row; its left end may be another
    // half-edge then, but the next row's is as it was.
    const Halfedge top_of_next = mesh.next(left[i + 1]);
    if (!try_merge(journal, top_of_next)) return false;
  }
  return true;
}

bool merge_all(Journal& journal, const Region& region, const std::vector<Halfedge>& tops) {
  if (region.columns >= region.rows) return merge_rows(journal, region, tops);
  const Region turned = region_views(journal.mesh(), region, tops)[1];
  return merge_rows(journal, turned, region_tops(journal.mesh(), turned));
}

}  // namespace

bool merge_region(Journal& journal, const Region& region, const std::vector<Halfedge>& tops) {
  const std::size_t depth = journal.depth();
  if (merge_all(journal, region, tops)) return true;
  while (journal.depth() > depth) journal.undo();
  return false;
}

}  // namespace gradmesh
