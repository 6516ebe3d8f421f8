#pragma once

#include <memory>
#include <optional>

#include "app/document/document.h"
#include "simplify/options.h"
#include "simplify/simplify.h"

namespace gradmesh {

struct ConvertOptions {
  /// Largest error of a conversion to a format that has no colours but the bilinear mixtures of
  /// four, such as SVG: patches are split where that is needed for an error of at most epsilon
  /// (simplify/adapt.h).
  double epsilon = 0.02;
  /// True if the conversion is refused where epsilon cannot be kept; otherwise the mesh with the
  /// least error that was found is taken.
  bool must_keep_epsilon = false;
  /// Instead of epsilon: every patch is split exactly into subdivide x subdivide, 1..32.
  std::optional<int> subdivide;
  /// The mesh whose picture counts, in the coordinates of the converted mesh; null if it is that
  /// mesh itself.
  std::shared_ptr<const Mesh> original;
  /// How the error is measured; the resolution in pixels along the longer side, as of
  /// check_resolution.
  MetricKind metric = MetricKind::flip;
  int resolution = usual_resolution;
};

struct Conversion {
  /// The new document, with the one mesh as a reader finds it.
  std::unique_ptr<Document> document;
  /// The mesh whose picture counts, in the coordinates of the new document.
  Mesh original;
  /// Error of the new document's mesh against the original, 0..1.
  double error = 0;
  /// True if the mesh had opacities, which the new document's format cannot hold.
  bool lost_opacity = false;
};

/// Makes a document of the format `to` that holds one mesh of `from`. If the formats differ, the
/// mesh is placed as Format::length and Format::margin say. Throws InputError if that cannot be
/// done, std::invalid_argument if an option is out of range.
Conversion convert(const Document& from, const MeshEntry& entry, const Format& to,
                   const ConvertOptions& options);

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
