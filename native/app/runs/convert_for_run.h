#pragma once

#include <memory>

#include "app/document/document.h"
#include "simplify/simplify.h"

namespace gradmesh {

/// A run whose result is a document of another format than the one that was read.
struct ConvertedRun {
  /// The document of the other format, which holds the one mesh that is to be simplified.
  std::unique_ptr<Document> document;
  /// The options of the run. They name the mesh as it was before the conversion, against which the
  /// error is measured, and the colour model.
  RunOptions options;
};

/// Converts a mesh of `from` to a document of another format, `to`, for a run with these options.
/// If the run has no target and the format has bilinear colours only, the conversion takes a share
/// of epsilon and leaves the rest for merging. Throws InputError as convert() does, if such a
/// conversion costs more than epsilon and the run has no target, and if opacities were lost.
ConvertedRun convert_for_run(const Document& from, const MeshEntry& entry, const Format& to,
                             RunOptions options);

}  // namespace gradmesh
