#pragma once

#include <string>

#include "formats/pdf/page/qpdf.h"

namespace gradmesh {

/// Returns what Illustrator keeps for itself beside a page: its own document, as text; empty where
/// there is none, or it is packed by Zstandard, as Illustrator 2020 and later do. Throws InputError
/// if it is longer than the limit of documents.
std::string private_data(QPDFPageObjectHelper page);

}  // namespace gradmesh
