#include "window/tools/shape_tool.h"

#include "window/eye/words.h"

namespace gradmesh {
namespace {

/// Within how many pixels of the pointer a point or handle is meant, on an ordinary screen.
constexpr double grip_reach = 10;

}  // namespace

void ShapeTool::point(Eye& eye, glm::dvec2 at, const Held&) {
  grip_ = grip_at(eye.session().mesh(), eye.to_pixels(), at, grip_reach * eye.density);
}

glm::dvec2 ShapeTool::place_of_grip(const Eye& eye) const {
  const Mesh& mesh = eye.session().mesh();
  if (grip_->point.valid()) return eye.to_pixels().point(mesh.position(grip_->point));
  const Cubic<Value> c = mesh.curve_of(grip_->curve);
  return eye.to_pixels().point((grip_->is_at_end ? c.bezier2() : c.bezier1()).position);
}

void ShapeTool::drag(Eye& eye, glm::dvec2 from, glm::dvec2 to, const Held& held, bool is_first) {
  if (is_first) {
    point(eye, from, held);
    if (grip_) aside_ = place_of_grip(eye) - from;
  }
  if (!grip_) return eye.viewport().pan(to - from);
  at_ = to + aside_;
  eye.propose([&](Session& session) {
    session.hands().propose_move(*grip_, eye.to_pixels().inverse().point(at_));
  });
}

void ShapeTool::drop(Eye& eye, const Held&) {
  eye.make();
  grip_.reset();
}

void ShapeTool::draw(const Eye& eye, const Pen& pen) const {
  if (!grip_) return;
  pen.dot(eye.session().hands().proposal() ? at_ : place_of_grip(eye), Pen::Ink::picked);
}

std::optional<Message> ShapeTool::hint(const Eye& eye) const {
  if (eye.session().hands().proposal()) return words_of_proposal(eye);
  if (grip_) return Message("Drag what is lit up. A drag beside it moves the picture.");
  return Message("Point at a point of the mesh, or at a handle, and drag it.");
}

}  // namespace gradmesh
