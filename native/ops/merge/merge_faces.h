#pragma once

#include <optional>
#include <span>

#include "ops/merge/merge.h"

namespace gradmesh {

/// What became of merge_faces(): the one patch, or why there is none.
struct MergedFaces {
  /// Invalid where they could not be merged.
  Face face;
  /// Of an edge between two of the patches that were left; `none` where these do not touch.
  MergeObstacle obstacle = MergeObstacle::none;
};

/// Makes one patch of several, by merging edges between them: as many operations of the journal.
/// Where that is not possible the mesh stays as it was. `faces` are alive, at least one.
MergedFaces merge_faces(Journal& journal, std::span<const Face> faces);

}  // namespace gradmesh
