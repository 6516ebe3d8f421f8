#pragma once

#include <string>

#include "formats/pdf/page/qpdf.h"

namespace gradmesh {

/// Returns what Illustrator keeps for itself beside a page: its own document, as text; empty where
/// there is none, or it is longer than the limit of documents. Throws InputError if it unpacks to
/// more than that.
std::string private_data(QPDFPageObjectHelper page);

}  // namespace gradmesh
