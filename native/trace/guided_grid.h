#pragma once

#include <vector>

#include "trace/line_grid.h"

namespace gradmesh {

/// A grid of which lines follow guides, and the numbers of the guides of which none does.
struct GuidedGrid {
  LineGrid grid;
  std::vector<std::size_t> unused = {};
};

/// Returns a grid whose lines were bent so that one follows each of the open lines that a person
/// drew, in the units of the grid, as mesh lines run along guides in Sun et al., "Image
/// vectorization using optimized gradient meshes" (2007). A guide is followed by the nearest line
/// along rows or columns, whichever it runs along more, or by a new one where that follows another.
/// Beyond its ends, which points hold, the line bends back. Of a guide that leaves the grid, turns
/// back on itself or comes too close to the border or an earlier guide that it cannot cross, the
/// longest piece that a line can follow is used. A guide is not used where the grid would have more
/// than `points` points or fold.
GuidedGrid guided_grid(const LineGrid& grid, const std::vector<std::vector<glm::dvec2>>& guides,
                       int points);

}  // namespace gradmesh
