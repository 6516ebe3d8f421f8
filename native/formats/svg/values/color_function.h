#pragma once

#include <glm/vec4.hpp>
#include <optional>

#include "formats/text/scanner.h"

namespace gradmesh {

/// Reads a colour function up to its closing parenthesis, such as rgb() or color(), as
/// parse_translucent_color() describes them. Returns nothing if that is no colour; the scanner's
/// place is any then.
std::optional<glm::dvec4> read_color_function(Scanner& scanner);

}  // namespace gradmesh
