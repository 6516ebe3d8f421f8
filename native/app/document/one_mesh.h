#pragma once

#include <string>
#include <vector>

#include "app/document/document.h"

namespace gradmesh {

/// Returns the mesh that `ids` name or, if there are no ids, the only one of the document. Throws
/// InputError if there are several; the message says that one is chosen with `option`.
MeshEntry one_mesh(const Document& document, const std::vector<std::string>& ids,
                   const std::string& option = "--id");
/// Returns the mesh that `id` names, as above; the only one of the document if `id` is empty.
MeshEntry one_mesh(const Document& document, const std::string& id);

}  // namespace gradmesh
