#include "window/tools/look_tool.h"

namespace gradmesh {

void LookTool::point(Eye& eye, glm::dvec2 at, const Held&) {
  if (const auto pointed = eye.pointed_at(at)) eye.patch_at_pointer = pointed->face;
}

void LookTool::click(Eye& eye, glm::dvec2 at, const Held&) {
  const auto pointed = eye.pointed_at(at);
  eye.element = {};
  if (!pointed) return;
  if (pointed->corner.valid())
    eye.element.point = eye.session().mesh().origin(pointed->corner);
  else if (pointed->side.valid())
    eye.element.halfedge = pointed->side;
  else
    eye.element.face = pointed->face;
}

void LookTool::drag(Eye& eye, glm::dvec2 from, glm::dvec2 to, const Held&, bool) {
  eye.viewport().pan(to - from);
}

void LookTool::draw(const Eye& eye, const Pen& pen) const {
  const Mesh& mesh = eye.session().mesh();
  const Affine map = eye.to_pixels();
  const Element& picked = eye.element;
  if (picked.point.valid()) pen.dot(map.point(mesh.position(picked.point)), Pen::Ink::picked);
  if (picked.face.valid()) pen.line(points_around(mesh, picked.face, map), true, Pen::Ink::picked);
  if (picked.halfedge.valid()) {
    const Halfedge h = picked.halfedge;
    const Cubic<Value> line = mesh.is_leaf(h) ? mesh.side_of(h) : mesh.curve_of(h);
    pen.line(points_along(line, map), false, Pen::Ink::picked);
    // A half-edge has a direction: a dot is where it begins.
    pen.dot(map.point(mesh.position(mesh.origin(h))), Pen::Ink::picked);
  }
}

std::optional<Message> LookTool::hint(const Eye&) const {
  return Message("Drag to move the picture; click a patch, a side or a point to see its numbers.");
}

}  // namespace gradmesh
