#pragma once

#include <optional>
#include <string_view>

#include "geom/box.h"

namespace gradmesh {

/// The exact box of SVG path data, all commands; empty if nothing is drawn (a lone moveto draws
/// nothing). Nothing if the data is malformed or has numbers beyond Scanner's limit.
std::optional<Box> path_box(std::string_view data);

}  // namespace gradmesh
