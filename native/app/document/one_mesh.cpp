#include "app/document/one_mesh.h"

namespace gradmesh {

MeshEntry one_mesh(const Document& document, const std::vector<std::string>& ids,
                   const std::string& option) {
  const auto found = document.selected(ids);
  if (found.size() > 1)
    throw InputError("{0}: there are {1} meshes, choose one with {2}.", document.name(),
                     found.size(), option);
  return found.front();
}

MeshEntry one_mesh(const Document& document, const std::string& id) {
  return one_mesh(document, id.empty() ? std::vector<std::string>{} : std::vector{id});
}

}  // namespace gradmesh
