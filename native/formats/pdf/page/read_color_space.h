#pragma once

#include "formats/pdf/color/color_space.h"
#include "formats/pdf/objects/qpdf.h"

namespace gradmesh {

/// Reads a colour space that a shading has (ISO 32000-1, 8.6). `named` is what the resources have
/// as ColorSpace: there a name is looked up, and what stands for the spaces of devices (8.6.5.6).
/// It may be null, of PDF. Throws InputError, whose message is a clause, if it is none in which
/// colours can be blended, such as Indexed.
ColorSpace read_color_space(QPDFObjectHandle object, const QPDFObjectHandle& named);

}  // namespace gradmesh
