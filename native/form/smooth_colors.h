#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/parts.h"

namespace gradmesh {

/// Meshes of type="bicubic" in SVG (Mesh::is_smooth), as Inkscape paints them. Between corners
/// colours follow cubic curves whose slopes come from the neighbouring corners, along rows and
/// along columns. So the mesh must be a grid (find_grid), and its unit that of its meshgradient,
/// since slopes depend on distances. Opacity is bilinear.

/// The colours that Inkscape gives to the patches of such a grid.
class SmoothColors {
 public:
  struct Corner {
    glm::dvec2 position;
    glm::dvec3 color;
  };
  /// Takes the (rows + 1) x (columns + 1) corners of the grid, row by row.
  SmoothColors(int rows, int columns, std::span<const Corner> corners);

  /// Gives a patch, with its own corners, the colours between them.
  void apply(Patch& patch, int row, int column) const;

 private:
  /// Slopes by row of corners and by column of corners.
  std::vector<std::vector<glm::dvec3>> right_, down_;
};

/// Returns the mesh in the model `bicubic`, with these colours as tangents: patches row by row.
MeshParts with_smooth_colors(const Mesh& mesh);

/// Returns the mesh as Inkscape paints it: each patch in 8 x 8 parts whose corners have the colours
/// of the smooth patch there, limited to [0, 1], bilinear between them. The parts of the whole grid
/// follow each other row by row, as Inkscape paints them, and are not joined. Their colours are not
/// those of stops, which have 8 bits, so they are held in the model `bicubic`.
Mesh painted_mesh(const Mesh& mesh);

/// Returns for each face of the painted_mesh the face of the mesh of which it is a part.
std::vector<Face> faces_of_painted_mesh(const Mesh& mesh);

}  // namespace gradmesh
