#pragma once

#include <string>

#include "draw/drawing.h"

namespace gradmesh {

/// Returns the drawing as an SVG document of its own, with its box as `viewBox`. The picture is
/// embedded.
std::string svg_text(const Drawing& drawing);

}  // namespace gradmesh
