#pragma once

#include "app/document/mesh_source.h"
#include "service/call.h"

namespace gradmesh {

/// Returns the mesh of the object that the argument `id` names, its fill if fill and stroke are
/// meshes. If it is null, or if it is that of an element around meshes, returns the only one there.
/// Throws InputError if there are several.
inline MeshEntry one_mesh(const Document& document, const Call& call) {
  const auto id = call.get<std::optional<std::string>>("id");
  const std::vector<std::string> ids = id ? std::vector{*id} : std::vector<std::string>{};
  for (const MeshEntry& entry : document.selected(ids))
    if (entry.id == id) return entry;
  return one_mesh(document, ids, "its id");
}

}  // namespace gradmesh
