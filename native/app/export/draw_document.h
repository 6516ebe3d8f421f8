#pragma once

#include <optional>
#include <string>

#include "app/runs/runs.h"

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
  /// regions: number of the patch; nothing for one of the largest region.
  std::optional<int> patch;
  /// regions: number of the region, from 1, by rising size, or 0 for all; nothing for the largest.
  std::optional<int> region;
  /// True if the mesh as it is painted lies behind the lines.
  bool picture = true;
  /// Options for the prices that the drawing needs.
  RunOptions simplify;
};

/// Draws one mesh as an SVG document of its own, in the coordinates of the document that holds it
/// (y down, without its viewBox). Throws InputError if there is no such patch or region, and
/// std::invalid_argument if one is given for another drawing than that of regions.
std::string draw(const Document& document, const MeshEntry& entry, const DrawOptions& options,
                 const PricePaths& analyses = {});

/// Returns the drawing of that name. Throws std::invalid_argument with all names if there is none.
Show show_named(const std::string& name);

}  // namespace gradmesh
