#pragma once

#include <string>

#include "document/document.h"

namespace gradmesh {

/// The mesh that `id` names or, where it is empty, the only one of the document. Throws InputError
/// where there are several.
MeshEntry one_mesh(const Document& document, const std::string& id);

}  // namespace gradmesh
