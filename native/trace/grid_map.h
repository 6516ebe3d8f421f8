#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "trace/line_grid.h"

namespace gradmesh {

/// Returns the place of a grid at a column and a row, x and y, whole numbers at its points.
glm::dvec2 place_at(const LineGrid& grid, glm::dvec2 column_and_row);

/// Returns the column and the row of a place; nothing where it does not lie in the grid.
std::optional<glm::dvec2> column_and_row(const LineGrid& grid, glm::dvec2 place);

}  // namespace gradmesh
