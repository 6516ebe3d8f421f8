#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/affine.h"

namespace gradmesh {

/// Returns the product of an SVG transform list (matrix, translate, scale, rotate, skewX, skewY);
/// the identity for an empty list or `none`; nothing if the list is malformed or its product is not
/// finite.
std::optional<Affine> parse_transform(std::string_view text);

/// Returns the map as a transform list, rounded as other numbers of a document are.
std::string transform_text(const Affine& map);

}  // namespace gradmesh
