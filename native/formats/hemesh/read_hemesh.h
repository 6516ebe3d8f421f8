#pragma once

#include <string>
#include <string_view>

#include "mesh/parts.h"

namespace gradmesh {

/// The mesh of a .hemesh text (see HemeshFile), for build_mesh; `name` is the file's, for messages.
/// Colour model `bicubic`, opaque. Positions are as in the file, y pointing down.
///
/// - Half-edges without a patch (leftovers of merges) are left out.
/// - Bars of bars become bars of the outermost parent; a single child that spans its whole parent
///   takes its place.
/// - A divided curve on the boundary becomes as many curves, since no patch lies across.
/// - A T-junction keeps the colours of the file where they are marked as recoloured or differ from
///   the parent's curve.
///
/// Throws InputError, one sentence with the file and, for most, the line: where numbers cannot be
/// read, records are missing, or no mesh can be made of them.
MeshParts read_hemesh(std::string_view text, const std::string& name);

}  // namespace gradmesh
