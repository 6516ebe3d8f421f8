#pragma once

#include <optional>
#include <string_view>

#include "base/affine.h"

namespace gradmesh {

/// The product of an SVG transform list (matrix, translate, scale, rotate, skewX, skewY); the
/// identity for an empty one or `none`. Nothing if the list is malformed or its product is not
/// finite.
std::optional<Affine> parse_transform(std::string_view text);

}  // namespace gradmesh
