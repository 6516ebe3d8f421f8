#pragma once

#include <string>
#include <string_view>

#include "mesh/mesh.h"
#include "mesh/parts.h"

namespace gradmesh {

/// Returns the mesh of a .hemesh text (see HemeshFile), for build_mesh; `name` is the file's, for
/// messages. The colour model is `bicubic`, all colours are opaque, and positions are as in the
/// file, y pointing down.
///
/// - Half-edges without a patch (leftovers of merges) are left out.
/// - Bars of bars become bars of the outermost parent; a single child that spans its whole parent
///   takes the parent's place.
/// - A divided curve on the boundary becomes one curve for each part, since no patch lies across.
/// - A T-junction keeps its colours of the file if they are marked as recoloured or differ from the
///   parent's curve.
///
/// Throws InputError, one sentence with the file and, for most errors, the line, if numbers cannot
/// be read, records are missing, or no mesh can be made of the records.
MeshParts read_hemesh(std::string_view text, const std::string& name);

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
