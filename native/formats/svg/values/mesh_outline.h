#pragma once

#include <string>

#include "mesh/mesh.h"

namespace gradmesh {

/// Returns the outline of a mesh as SVG path data, for the fill rule nonzero: parts of the mesh may
/// lie over one another, and holes stay holes. Returns an empty string if the mesh has no boundary.
std::string outline_path(const Mesh& mesh);

/// Returns the outlines of all patches as SVG path data, for the fill rule nonzero: those of a
/// folded mesh lie beyond its outline.
std::string patches_path(const Mesh& mesh);

/// Returns a path around all that a mesh paints, for the fill rule nonzero: its outline or, where
/// sheets of it lie over one another so that their turns would cancel, those of its patches; for
/// one that folds it is the convex polygon around it, which reaches beyond it.
std::string covering_path(const Mesh& mesh);

}  // namespace gradmesh
