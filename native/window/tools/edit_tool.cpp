#include "window/tools/edit_tool.h"

#include <algorithm>

#include "window/eye/words.h"

namespace gradmesh {

namespace {

struct Kind {
  HandEdit edit;
  Message name, tip;
  const char* key;
};

const Kind& kind_of(HandEdit edit) {
  static const Kind all[] = {
      {HandEdit::merge, Message("Take out"),
       Message("A click on a line takes it out, or merges the patches beside it (M)"), "M"},
      {HandEdit::split_rows, Message("New row"),
       Message("A click puts a line in, from left to right in the mesh (R)"), "R"},
      {HandEdit::split_columns, Message("New column"),
       Message("A click puts a line in, from top to bottom in the mesh (C)"), "C"},
      {HandEdit::split_both, Message("New cross"),
       Message("A click puts both lines in (B; or hold Ctrl)"), "B"}};
  return *std::find_if(std::begin(all), std::end(all),
                       [&](const Kind& kind) { return kind.edit == edit; });
}

}  // namespace

Message EditTool::name() const { return kind_of(edit_).name; }
Message EditTool::tip() const { return kind_of(edit_).tip; }
const char* EditTool::key() const { return kind_of(edit_).key; }

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
  if (now == asked_) return;
  eye.propose([&](Session& session) { session.hands().propose(*pointed, edit); });
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
  if (eye.session().hands().proposal()) return words_of_proposal(eye);
  if (const auto marked = Marking::hint(eye)) return marked;
  if (edit_ == HandEdit::merge) return Message("Point at a line to see what taking it out costs.");
  return Message("Point at a patch to see where the line goes, and what it does.");
}

}  // namespace gradmesh
