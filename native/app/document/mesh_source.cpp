#include "app/document/mesh_source.h"

namespace gradmesh {

std::vector<FilledOutline> MeshSource::covered(const std::vector<std::string>&) const {
  throw InputError("{0}: shapes that cover parts of a mesh are known in SVG documents only.",
                   name());
}

ChosenPatches MeshSource::whole(const MeshEntry& entry) const {
  const auto grid = find_grid(mesh(entry));
  if (!grid) throw InputError("{0}: its mesh is not one rectangle of patches.", describe(entry));
  return {entry, *grid};
}

MeshEntry one_mesh(const MeshSource& document, const std::vector<std::string>& ids,
                   const std::string& option) {
  const auto found = document.selected(ids);
  if (found.size() > 1)
    throw InputError("{0}: there are {1} meshes, choose one with {2}.", document.name(),
                     found.size(), option);
  return found.front();
}

MeshEntry one_mesh(const MeshSource& document, const std::string& id) {
  return one_mesh(document, id.empty() ? std::vector<std::string>{} : std::vector{id});
}

}  // namespace gradmesh
