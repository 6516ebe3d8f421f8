#pragma once

#include "formats/pdf/color/color_space.h"
#include "formats/pdf/page/qpdf.h"

namespace gradmesh {

/// Reads a colour space that a shading has (ISO 32000-1, 8.6). Throws InputError, whose message is
/// a clause, if it is none in which colours can be blended, such as Indexed.
ColorSpace read_color_space(QPDFObjectHandle object);

}  // namespace gradmesh
