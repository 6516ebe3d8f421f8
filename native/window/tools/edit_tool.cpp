#include "window/tools/edit_tool.h"

#include "window/eye/words.h"

namespace gradmesh {

Message EditTool::name() const {
  switch (edit_) {
    case HandEdit::merge:
      return Message("Take out");
    case HandEdit::split_rows:
      return Message("New row");
    case HandEdit::split_columns:
      return Message("New column");
    case HandEdit::split_both:
      break;
  }
  return Message("New cross");
}

Message EditTool::tip() const {
  switch (edit_) {
    case HandEdit::merge:
      return Message("A click on a line takes it out, or merges the patches beside it (M)");
    case HandEdit::split_rows:
      return Message("A click puts a line in, from left to right in the mesh (R)");
    case HandEdit::split_columns:
      return Message("A click puts a line in, from top to bottom in the mesh (C)");
    case HandEdit::split_both:
      break;
  }
  return Message("A click puts both lines in (B; or hold Ctrl)");
}

const char* EditTool::key() const {
  switch (edit_) {
    case HandEdit::merge:
      return "M";
    case HandEdit::split_rows:
      return "R";
    case HandEdit::split_columns:
      return "C";
    case HandEdit::split_both:
      break;
  }
  return "B";
}

void EditTool::point(Eye& eye, glm::dvec2 at, const Held& held) {
  propose(eye, at, held.control ? HandEdit::split_both : edit_);
}

void EditTool::propose(Eye& eye, glm::dvec2 at, HandEdit edit) {
  const auto pointed = eye.pointed_at(at);
  if (pointed) eye.patch_at_pointer = pointed->face;
  // Beside the mesh, or where no line is to be taken out, a person does nothing wrong.
  const bool is_line = edit == HandEdit::merge;
  if (!pointed || (is_line && !pointed->edge.valid())) return leave(eye);
  const Asked now{eye.revision(), edit, pointed->edge, is_line ? glm::dvec2(0.0) : at};
  if (now.revision == asked_.revision && now.edit == asked_.edit && now.edge == asked_.edge &&
      now.at == asked_.at)
    return;
  eye.propose([&](Session& session) { session.propose(*pointed, edit); });
  asked_ = now;
  asked_.revision = eye.revision();
}

void EditTool::leave(Eye& eye) {
  asked_ = {};
  eye.forget_proposal();
}

void EditTool::click(Eye& eye, glm::dvec2 at, const Held& held) {
  if (held.shift) {
    if (const auto pointed = eye.pointed_at(at)) eye.toggle_mark(pointed->face);
    eye.price_marks();
    return;
  }
  point(eye, at, held);
  eye.make();
}

void EditTool::drag(Eye& eye, glm::dvec2 from, glm::dvec2 to, const Held& held, bool is_first) {
  asked_ = {};
  Marking::drag(eye, from, to, held, is_first);
}

std::optional<Message> EditTool::hint(const Eye& eye) const {
  if (eye.session().proposal()) return words_of_proposal(eye);
  if (const auto marked = Marking::hint(eye)) return marked;
  if (edit_ == HandEdit::merge) return Message("Point at a line to see what taking it out costs.");
  return Message("Point at a patch to see where the line goes, and what it does.");
}

}  // namespace gradmesh
