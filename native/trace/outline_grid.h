#pragma once

#include <optional>

#include "geom/outline.h"
#include "trace/line_grid.h"

namespace gradmesh {

/// Returns a grid that follows the outline of a shape on a picture of this size, from four corners:
/// those of its sharpest corners that lie near the ends of its diagonals, and these elsewhere. Its
/// border is a polygon around the shape, at least a pixel away, as the shape itself cuts the mesh;
/// its lines lie between, bent as its sides are. Of several polygons the one with the largest area
/// counts, holes do not. Nothing where such a grid would fold or leave some of the shape uncovered.
/// The outline is in pixels of the picture.
std::optional<LineGrid> outline_grid(const Outline& outline, int rows, int columns,
                                     glm::dvec2 size);

}  // namespace gradmesh
