#pragma once

#include <memory>

#include "app/document/svg_document.h"
#include "reference/original.h"

namespace gradmesh {

/// Returns the picture that a mesh was traced from, in the units of the mesh, if the document still
/// shows it as it did then, its file can be read and is the same, and no person has edited the mesh
/// since; else null. `resolution` is that at which it will be painted.
std::shared_ptr<const Original> traced_original(const SvgDocument& svg, const MeshEntry& entry,
                                                int resolution);

}  // namespace gradmesh
