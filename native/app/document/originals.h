#pragma once

#include <memory>

#include "app/document/mesh_source.h"

namespace gradmesh {

/// Returns the mesh of MeshSource::originals() that corresponds to `entry`, in the units of the
/// mesh of `entry`; null if there is no such document. Throws InputError if no mesh corresponds.
std::shared_ptr<const Mesh> given_original(const MeshSource& document, const MeshEntry& entry);
/// Returns the mesh against which runs measure: its given_original, or the original that the mesh
/// remembers unless a person has edited the mesh since; null if the mesh itself.
std::shared_ptr<const Mesh> known_original(const MeshSource& document, const MeshEntry& entry);
/// Returns true if the mesh may have been moved away from an original before.
bool may_differ(const MeshSource& document, const MeshEntry& entry);

}  // namespace gradmesh
