#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/document.h"
#include "simplify/options.h"

namespace gradmesh {

/// Edits of single patches, as a person asks for them in a drawing. Blocks are named by the ids of
/// their paths. All throw InputError, also for .hemesh files; the document is then unchanged.

/// How the error in the label is measured.
struct MeasureOptions {
  MetricKind metric = MetricKind::flip;
  int resolution = usual_resolution;
};

struct EditReport {
  /// Id of the mesh.
  std::string id;
  MeshCounts before, after;
  /// The number of objects that paint the mesh afterwards.
  int objects = 0;
  /// Error against the original that the mesh remembers, or else against the mesh as it was.
  double error = 0;
};

/// Merges all patches of these blocks, which are of one mesh, to one patch.
EditReport merge_blocks(Document& document, const std::vector<std::string>& ids,
                        const MeasureOptions& measure = {});

struct RefineOptions {
  /// True if patches are cut by a line from left to right (rows), from top to bottom (columns).
  bool rows = true, columns = true;
  /// Where the lines lie, from the top and from the left of each patch, above 0 and below 1.
  double place = 0.5;
  /// Row and column of the patches to cut in the block, from 1; nothing for all.
  std::optional<int> row, column;
  /// True if the lines go on across the whole mesh.
  bool whole = false;
};

/// Splits patches of a block, or of an object that is painted by a rectangular mesh, exactly.
EditReport refine(Document& document, const std::string& id, const RefineOptions& options,
                  const MeasureOptions& measure = {});

/// Turns simplified meshes into objects with one ordinary mesh gradient again: the line that ends
/// at a T-junction goes on across the mesh, which is exact but for the rounding of colours at new
/// points to 8 bits. The reported error is against the simplified mesh. Ids that name other meshes
/// are ignored. Throws if no mesh is simplified, or if one is no rectangle (holes, branches), has
/// several colours at one point, or would have more than 100,000 patches.
std::vector<EditReport> to_one_mesh(Document& document, const std::vector<std::string>& ids,
                                    const MeasureOptions& measure = {});

}  // namespace gradmesh
