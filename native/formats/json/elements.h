#pragma once

#include <nlohmann/json_fwd.hpp>

#include "mesh/mesh.h"

namespace gradmesh {

/// Returns the half-edge structure of a mesh:
///   {"points":    [{"id", "position": [x, y], "halfedge", "stem"}],
///    "handles":   [{"id", "halfedge", "tangent"}],
///    "faces":     [{"id", "halfedges": [top, right, bottom, left]}],
///    "halfedges": [{"id", "origin", "face", "next", "prev", "twin", "parent", "children": [],
///                   "interval": [from, to], "handles": [start, end],
///                   "color": [r, g, b, a], "own_color", "twist"}]}
/// Elements are named by the indices that they have everywhere in this program; what an element
/// does not have is null. Tangents and twists are [x, y], in the colour model `bicubic`
/// [x, y, r, g, b, a]. y points down. See mesh/elements.h for what the fields mean.
nlohmann::ordered_json elements_json(const Mesh& mesh);

}  // namespace gradmesh
