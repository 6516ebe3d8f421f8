#include "session/mesh_lines.h"

#include "session/pointing.h"

namespace gradmesh {

const Ink below_lines{glm::dvec3(0.0), 0.35, 2.6};

void draw_lines(Canvas& canvas, const Mesh& mesh, const Affine& to_pixels) {
  const Ink light{glm::dvec3(1.0), 0.85, 1.1};
  std::vector<std::vector<glm::dvec2>> lines;
  for (const Halfedge curve : mesh.curves())
    lines.push_back(points_along(mesh.curve_of(curve), to_pixels));
  canvas.lines(lines, below_lines);
  canvas.lines(lines, light);
}

}  // namespace gradmesh
