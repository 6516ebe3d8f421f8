#pragma once

#include <vector>

#include "mesh/region.h"
#include "ops/journal.h"

namespace gradmesh {

/// The view in which a region is merged: along its longer direction first, which has turned out to
/// change the mesh less. So it has at least as many columns as rows. `tops` as of region_tops.
Region merging_view(const Mesh& mesh, const Region& region, const std::vector<Halfedge>& tops);

/// Merges a region into one patch, as one operation of the journal for each merge: in its
/// merging_view row by row, each along itself and then with the rows above. `tops` as of
/// region_tops. False where one of the merges cannot be made (can_merge): then nothing is changed.
bool merge_region(Journal& journal, const Region& region, const std::vector<Halfedge>& tops);

/// Merges one region after another, each alone, and keeps the rows that the next has in common
/// with it. So regions that grow by rows cost one row each, if they are asked for by the face, top,
/// columns and rows of their merging_view.
class RegionMerger {
 public:
  /// `start` is the journal's mesh as it is now, and stays so. As long as a region is merged, the
  /// journal is not to be changed by others.
  RegionMerger(Journal& journal, const Mesh& start)
      : journal_(journal), start_(start), depth_(journal.depth()) {}

  /// Leaves the journal with this region of `start` merged, as by merge_region, and no other. False
  /// where there is no such region or it cannot be merged: then nothing is merged.
  bool merge(const Region& region);
  /// Takes all back.
  void undo() { keep_rows(0); }

 private:
  void keep_rows(int rows);

  Journal& journal_;
  const Mesh& start_;
  const std::size_t depth_;
  /// What is merged; without rows: nothing.
  Region view_{{}, 0, 0, 1};
};

}  // namespace gradmesh
