#pragma once

#include <optional>
#include <string_view>

#include "geom/box.h"
#include "geom/outline.h"

namespace gradmesh {

/// The exact box of SVG path data, all commands; empty if nothing is drawn (a lone moveto draws
/// nothing). Nothing if the data is malformed or has numbers beyond Scanner's limit.
std::optional<Box> path_box(std::string_view data);

/// How many lines stand for one curve in an outline.
inline constexpr int outline_steps = 128;

/// The subpaths as polygons; nothing as above.
std::optional<Outline> path_outline(std::string_view data);

}  // namespace gradmesh
