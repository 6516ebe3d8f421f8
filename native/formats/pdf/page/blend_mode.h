#pragma once

#include <string>

#include "formats/pdf/objects/qpdf.h"

namespace gradmesh {

/// Returns the CSS word for the /BM of a graphics state, or for the first of several that is known
/// (ISO 32000-1, 11.3.5): "multiply"; "normal" for one that is not known.
std::string blend_mode_of(QPDFObjectHandle modes);

}  // namespace gradmesh
