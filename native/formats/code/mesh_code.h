#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "geom/outline.h"

namespace gradmesh {

/// What the mesh gradients of programming toolkits (SwiftUI's MeshGradient, Compose's
/// MeshGradientPainter) hold of a mesh. All places are in the unit square, y down, to which the box
/// around the mesh is mapped.

/// The sides of a vertex on which it has a handle, in the order of CodeVertex::handles.
enum class HandleSide { left, top, right, bottom };

struct CodeVertex {
  glm::dvec2 position{0.0};
  /// In sRGB, 0..1, with the opacity.
  glm::dvec4 color{0.0};
  /// The control points beside the vertex, by HandleSide; the position itself where the grid ends.
  std::array<glm::dvec2, 4> handles{};

  glm::dvec2& handle(HandleSide side) { return handles[std::size_t(side)]; }
};

/// Patches in rows and columns.
struct CodeGrid {
  int rows = 0, columns = 0;
  /// (rows + 1) * (columns + 1) of them, row by row.
  std::vector<CodeVertex> vertices;
};

struct MeshCode {
  /// The id of the object that the mesh paints: any text.
  std::string id;
  /// What the code calls the mesh (formats/code/code_names.h).
  std::string name;
  /// In the order in which they are painted.
  std::vector<CodeGrid> grids;
  /// True if colours follow cubic curves between vertices instead of being bilinear.
  bool smooth = false;
  /// The mesh is seen where it lies inside of all of these.
  std::vector<FilledOutline> clips;
  /// The opacity of the whole, 0..1.
  double opacity = 1;
  /// The width of the box around the mesh by its height.
  double aspect_ratio = 1;
};

}  // namespace gradmesh
