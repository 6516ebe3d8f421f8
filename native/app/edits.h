#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/document.h"

namespace gradmesh {

/// Edits of single patches, as a person asks for them in a drawing. Blocks are named by the ids of
/// their paths. All throw InputError, for .hemesh files too; the document is then as it was.

/// How the error is measured that the label tells.
struct MeasureOptions {
  MetricKind metric = MetricKind::flip;
  int resolution = 700;
};

struct EditReport {
  /// Of the mesh.
  std::string id;
  int patches_before = 0, patches_after = 0;
  /// Against the original that the mesh remembers, or else the mesh as it was.
  double error = 0;
};

/// Makes one patch of all patches of these blocks, which are of one mesh.
EditReport merge_blocks(Document& document, const std::vector<std::string>& ids,
                        const MeasureOptions& measure = {});

struct RefineOptions {
  /// Whether patches are cut by a line from left to right, from top to bottom.
  bool rows = true, columns = true;
  /// Where: from the top and from the left of each patch, above 0 and below 1.
  double place = 0.5;
  /// Which patches of the block, from 1; nothing: all.
  std::optional<int> row, column;
  /// Whether the lines go on across the whole mesh.
  bool whole = false;
};

/// Splits patches of a block, or of an object that is painted by a rectangular mesh. Exact.
EditReport refine(Document& document, const std::string& id, const RefineOptions& options,
                  const MeasureOptions& measure = {});

/// Makes of simplified meshes objects with one ordinary mesh gradient again: every T-junction's
/// line goes on across the mesh, which is exact but for the rounding of colours at new points to 8
/// bits. The error is against the simplified mesh. Those of the ids that name other meshes are left
/// out. Throws where no mesh is simplified, where one is no rectangle (holes, branches), has
/// several colours at one point, or would have more than 100,000 patches.
std::vector<EditReport> to_one_mesh(Document& document, const std::vector<std::string>& ids,
                                    const MeasureOptions& measure = {});

}  // namespace gradmesh
