#pragma once

#include <string>

#include "base/affine.h"
#include "formats/svg/tree/svg_tree.h"
#include "mesh/mesh.h"

namespace gradmesh {

/// Returns the map from the user space of the shape with this id to that of the outermost <svg>.
/// Throws InputError if there is no shape that a mesh gradient can fill: a path, rectangle, circle,
/// ellipse or polygon with an area, that a transform has not flattened.
Affine user_to_document(const SvgTree& tree, const std::string& id);

/// Fills a shape by a new mesh gradient, fully opaque but for the mesh's own opacities, and takes
/// its stroke away, which is how an outline is drawn over what it surrounds. The shape is otherwise
/// unchanged. What it was painted by is removed if nothing else uses it. The mesh is a grid in the
/// shape's user space, as of write_grid. Throws as user_to_document does.
void paint_shape(SvgTree& tree, const std::string& id, const Mesh& mesh, double coons_tolerance);

}  // namespace gradmesh
