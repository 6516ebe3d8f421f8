#pragma once

#include <optional>
#include <string>

#include "app/document.h"

namespace gradmesh {

/// What a drawing of a mesh shows.
enum class Show {
  edges,       ///< curves, points, handles, and the numbers of the half-edges
  faces,       ///< patches and their numbers
  errors,      ///< what merging single edges costs
  motorcycle,  ///< the motorcycle graph
  regions,     ///< those of one patch that can be merged within epsilon
};

struct DrawOptions {
  Show show = Show::edges;
  /// regions: the number of the patch; otherwise one of the largest region.
  std::optional<int> patch;
  /// regions: which one, from 1, by rising size; 0: all; otherwise the largest.
  std::optional<int> region;
  /// Whether the mesh as it is painted lies behind the lines.
  bool picture = true;
  /// Of the prices that the drawing needs.
  RunOptions simplify;
};

/// Draws one mesh as an SVG document of its own, in the coordinates of the document that holds it
/// (y down, without its viewBox). Throws InputError where there is no such patch or region, and
/// std::invalid_argument where these are named for another drawing than that of regions.
std::string draw(const Document& document, const MeshEntry& entry, const DrawOptions& options,
                 const AnalysisPaths& analyses = {});

/// Throws std::invalid_argument with the names there are.
Show show_named(const std::string& name);

}  // namespace gradmesh
