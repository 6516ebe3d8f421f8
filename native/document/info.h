#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "document/document.h"

namespace gradmesh {

/// What is in a document:
///   {"file", "kind": "svg" or "hemesh",
///    "meshes": [{"id", "role": "fill", "stroke" or null, "simplified", "color_model",
///                "patches", "points", "t_junctions", "elements"}]}
/// with counts in "points" and "t_junctions", and the half-edge structure in "elements":
///   {"points":    [{"id", "position": [x, y], "halfedge", "stem"}],
///    "handles":   [{"id", "halfedge", "tangent"}],
///    "faces":     [{"id", "halfedges": [top, right, bottom, left]}],
///    "halfedges": [{"id", "origin", "face", "next", "prev", "twin", "parent", "children": [],
///                   "interval": [from, to], "handles": [start, end],
///                   "color": [r, g, b, a], "own_color", "twist"}]}
/// Elements are named by the indices that they have everywhere in this program; what an element
/// does not have is null. Tangents and twists are [x, y], in the colour model `bicubic`
/// [x, y, r, g, b, a]. y points down. See mesh/elements.h for what the fields mean.
nlohmann::ordered_json info_json(const Document& document);

/// The same as text, an element a line.
std::string info_text(const Document& document);

}  // namespace gradmesh
