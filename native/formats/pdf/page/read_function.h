#pragma once

#include "formats/pdf/color/function.h"
#include "formats/pdf/objects/qpdf.h"

namespace gradmesh {

/// Reads a Function, or an array of functions of one output each (ISO 32000-1, 7.10). Throws
/// InputError, whose message is a clause, if it is none, or one inside another without end.
Function read_function(QPDFObjectHandle object);

}  // namespace gradmesh
