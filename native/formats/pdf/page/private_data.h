#pragma once

#include <string>

#include "formats/pdf/objects/qpdf.h"

namespace gradmesh {

/// Returns what Illustrator keeps for itself beside a page: its own document, as text; empty where
/// there is none, or all its streams are longer than the limit of documents. Throws InputError if
/// one of them is, or what they unpack to.
std::string private_data(QPDFPageObjectHelper page);

}  // namespace gradmesh
