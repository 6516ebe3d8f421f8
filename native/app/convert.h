#pragma once

#include <memory>
#include <optional>

#include "app/document.h"

namespace gradmesh {

struct ConvertOptions {
  /// Towards SVG, which knows no colours but the bilinear mixtures of four: patches are split where
  /// that is needed for an error of at most epsilon (simplify/adapt.h).
  double epsilon = 0.02;
  /// Whether it is refused where epsilon cannot be kept; else the least error that was found
  /// counts.
  bool must_keep_epsilon = false;
  /// Instead: every patch is split exactly into subdivide x subdivide, 1..32.
  std::optional<int> subdivide;
  /// Whose picture counts, in the coordinates of the mesh, where that is not the mesh itself.
  std::shared_ptr<const Mesh> original;
  /// How the error is measured; in pixels along the longer side, as of check_resolution.
  MetricKind metric = MetricKind::flip;
  int resolution = 700;
};

struct Conversion {
  /// Holds the one mesh, as a reader finds it.
  std::unique_ptr<Document> document;
  /// The mesh whose picture counts, in the coordinates of the new document.
  Mesh original;
  /// Of the new document's mesh against the original, 0..1.
  double error = 0;
  /// Whether the mesh had opacities, which a .hemesh file cannot hold.
  bool lost_opacity = false;
};

/// Makes a document of the other kind, or a .hemesh file of a .hemesh file, that holds one mesh of
/// `from`. Towards SVG its longer side becomes 600 pixels, from SVG to .hemesh 2 units. Throws
/// InputError where that cannot be done, std::invalid_argument where an option is out of range.
Conversion convert(const Document& from, const MeshEntry& entry, DocumentKind to,
                   const ConvertOptions& options);

}  // namespace gradmesh
