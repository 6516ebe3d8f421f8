#include "window/tools/mark_tool.h"

namespace gradmesh {

Message MarkTool::tip() const {
  if (brushes_) return Message("A drag marks every patch that it touches (T; or hold Alt)");
  return Message(
      "Drag straight to mark a rectangle, or in a curve around what you mean: patches with a third "
      "inside are marked. A click marks or unmarks one (K)");
}

void MarkTool::point(Eye& eye, glm::dvec2 at, const Held&) {
  if (const auto pointed = eye.pointed_at(at)) eye.patch_at_pointer = pointed->face;
}

void MarkTool::click(Eye& eye, glm::dvec2 at, const Held&) {
  if (const auto pointed = eye.pointed_at(at)) eye.toggle_mark(pointed->face);
  eye.price_marks();
}

std::optional<Message> MarkTool::hint(const Eye& eye) const {
  if (!eye.marked().empty()) return Marking::hint(eye);
  if (brushes_) return Message("The brush marks every patch that it touches.");
  return Message("Drag around patches, or click one, to mark them.");
}

}  // namespace gradmesh
