#pragma once

#include <optional>
#include <span>

#include "ops/merge/merge.h"

namespace gradmesh {

/// The result of merge_faces(): the one patch, or why there is none.
struct MergedFaces {
  /// The one patch; invalid if the faces could not be merged.
  Face face;
  /// The obstacle of an edge between two of the patches that were left; `none` if no two of these
  /// touch.
  MergeObstacle obstacle = MergeObstacle::none;
};

/// Makes one patch of several by merging edges between them, each as one operation of the journal.
/// Where that is not possible the mesh stays as it was. `faces` are alive, at least one.
MergedFaces merge_faces(Journal& journal, std::span<const Face> faces);

}  // namespace gradmesh
