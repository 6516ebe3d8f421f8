#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "form/blocks.h"
#include "mesh/parts.h"

namespace gradmesh {

/// The text of curves with more than one block along them (formats/svg/group/mesh_group.h).
/// Half-edge 4 * face + side is side `side` (0 top, 1 right, 2 bottom, 3 left) of a patch. A curve
/// is `side | side`, a side `halfedge break halfedge ... halfedge`; curves are separated by
/// semicolons. A side that is not named is joined as in a grid inside its block, or is on the
/// boundary.

/// Returns the text for a mesh in these blocks.
std::string format_curves(const Mesh& mesh, const std::vector<Rectangle>& blocks);

/// Returns the curves of a text, which may name any number as a half-edge; nothing if the text is
/// none.
std::optional<std::vector<CurveParts>> parse_curves(std::string_view text);

}  // namespace gradmesh
