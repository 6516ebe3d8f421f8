#pragma once

#include <string>

#include "mesh/mesh.h"

namespace gradmesh {

/// Returns the mesh as the text of a .hemesh file (see HemeshFile). The colour model must be
/// `bicubic` (as_bicubic makes it so). Opacities and HalfedgeRecord::own_tangents are dropped, as
/// the format has none.
///
/// read_hemesh makes the same mesh of the text: patches, T-junctions, sharp colours and tangents
/// bit for bit, faces in the same order. Elements that are not alive are left out, and the order of
/// the others depends on the faces alone, so that a mesh that was read is written as the same text
/// again.
std::string write_hemesh(const Mesh& mesh);

}  // namespace gradmesh
