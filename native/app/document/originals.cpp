#include "app/document/originals.h"

#include "app/document/frames.h"
#include "form/smooth_colors.h"
#include "mesh/build.h"
#include "mesh/subdivide.h"

namespace gradmesh {

std::shared_ptr<const Mesh> given_original(const MeshSource& document, const MeshEntry& entry) {
  const MeshSource* const originals = document.originals();
  if (!originals) return nullptr;
  const MeshEntry match =
      counterpart(document, entry, *originals, document.selected({}).size() == 1);
  const MeshInDocument here{&document, entry, document.mesh(entry)};
  const MeshInDocument there{originals, match, originals->mesh(match)};
  if (document.format() == originals->format() && here.view() == there.view())
    return std::make_shared<const Mesh>(there.mesh);
  // Smooth colours depend on distances in the units of their own mesh.
  MeshParts parts = subdivided(there.mesh.is_smooth() ? painted_mesh(there.mesh) : there.mesh, 1);
  transform(parts, onto(here, there));
  return std::make_shared<const Mesh>(build_derived_mesh(parts));
}

std::shared_ptr<const Mesh> known_original(const MeshSource& document, const MeshEntry& entry) {
  const std::shared_ptr<const Mesh> given = given_original(document, entry);
  return given ? given : document.remembered_original(entry);
}

bool may_differ(const MeshSource& document, const MeshEntry& entry) {
  return entry.simplified || document.remembered_original(entry) || document.originals();
}

}  // namespace gradmesh
