#pragma once

#include <string>
#include <vector>

#include "app/document.h"

namespace gradmesh {

/// The mesh that `ids` name or, where there are none, the only one of the document. Throws
/// InputError where there are several.
MeshEntry one_mesh(const Document& document, const std::vector<std::string>& ids);
/// The same with one id, which may be empty.
MeshEntry one_mesh(const Document& document, const std::string& id);

}  // namespace gradmesh
