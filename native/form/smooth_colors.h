#pragma once

#include "mesh/mesh.h"
#include "mesh/parts.h"

namespace gradmesh {

/// Meshes of type="bicubic" in SVG (Mesh::is_smooth), as Inkscape paints them. Between corners
/// colours follow cubic curves whose slopes come from the neighbouring corners, along rows and
/// along columns. So the mesh must be a grid (find_grid), and its unit that of its meshgradient,
/// since slopes depend on distances. Opacity is bilinear.

/// Returns the mesh in the model `bicubic`, with these colours as tangents: patches row by row.
MeshParts with_smooth_colors(const Mesh& mesh);

/// Returns the mesh as Inkscape paints it: each patch in 8 x 8 parts whose corners have the colours
/// of the smooth patch there, limited to [0, 1], bilinear between them. The parts of the whole grid
/// follow each other row by row, as Inkscape paints them, and are not joined. Their colours are not
/// those of stops, which have 8 bits, so they are held in the model `bicubic`.
Mesh painted_mesh(const Mesh& mesh);

}  // namespace gradmesh
