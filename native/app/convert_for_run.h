#pragma once

#include <memory>

#include "app/document.h"

namespace gradmesh {

/// A run whose result is a document of another kind than the one that was read.
struct ConvertedRun {
  /// The document of the other kind, which holds the one mesh that is to be simplified.
  std::unique_ptr<Document> document;
  /// The options of the run. They name the mesh as it was before the conversion, against which the
  /// error is measured, and the colour model.
  RunOptions options;
};

/// Converts a mesh of `from` to a document of the other kind, `kind`, for a run with these options.
/// If the run has no target, towards SVG the conversion takes a share of epsilon and leaves the
/// rest for merging. Throws InputError as convert() does, if the conversion costs more than epsilon
/// and the run has no target, and if opacities were lost.
ConvertedRun convert_for_run(const Document& from, const MeshEntry& entry, DocumentKind kind,
                             RunOptions options);

}  // namespace gradmesh
