#pragma once

#include <optional>
#include <string_view>

#include "geom/box.h"
#include "geom/outline.h"

namespace gradmesh {

/// Returns the exact box of SVG path data, all commands; an empty box if nothing is drawn (a lone
/// moveto draws nothing). Returns nothing if the data is malformed or has numbers beyond Scanner's
/// limit.
std::optional<Box> path_box(std::string_view data);

/// Number of lines by which an outline approximates one curve.
inline constexpr int outline_steps = 128;

/// Returns the subpaths as polygons; nothing in the cases in which path_box returns nothing.
std::optional<Outline> path_outline(std::string_view data);

}  // namespace gradmesh
