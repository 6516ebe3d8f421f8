// The operators of text (ISO 32000-1, table 106 to 109).

#include "formats/pdf/objects/dictionary.h"
#include "formats/pdf/page/content_operators.h"

namespace gradmesh {

void ContentOperators::set_font() {
  QPDFObjectHandle name = operand(0);
  if (!name.isName()) return;
  state_.text.font = reader_.font(value_of(value_of(resources_, "/Font"), name.getName()));
  state_.text.size = number(1);
}

void ContentOperators::move_line_and_set_leading() {
  state_.text.leading = -number(1);
  move_line();
}

void ContentOperators::show_on_next_line() {
  next_line();
  show(operands_.back());
}

void ContentOperators::show_spaced_on_next_line() {
  state_.text.word_space = number(0);
  state_.text.character_space = number(1);
  show_on_next_line();
}

void ContentOperators::show_texts() {
  QPDFObjectHandle parts = operand(0);
  if (!parts.isArray()) return;
  for (QPDFObjectHandle part : parts.getArrayAsVector()) {
    if (const auto room = number_of(part))
      text_place_.leave_room(*room, state_.text);
    else
      show(part);
  }
}

void ContentOperators::show(QPDFObjectHandle text) {
  if (!text.isString()) return;
  const TextStyle& style = state_.text;
  const bool is_painted = (style.fills() && (state_.pattern || reader_.marks_)) ||
                          (style.strokes() && (state_.stroke_pattern || reader_.marks_));
  const TextOnPage shown =
      text_place_.show(text.getStringValue(), style, state_.to_page, is_painted || style.clips());
  GraphicsState inside = state_;
  inside.text = {};
  inside.is_hidden = is_hidden();
  constexpr int invisible = 3;
  if (style.mode != invisible)
    for (const TextOnPage::Content& glyph : shown.contents) {
      inside.to_page = glyph.to_page;
      QPDFObjectHandle own = style.font->resources();
      reader_.read_glyph(glyph.content, own.isDictionary() ? own : resources_, inside);
    }
  const auto add = [&](TextOnPage& to) {
    append(to.outline, shown.outline);
    to.has_boxes = to.has_boxes || shown.has_boxes;
  };
  if (is_painted) add(unpainted_text_);
  if (style.clips()) add(clip_text_);
  text_clips_ = text_clips_ || style.clips();
}

void ContentOperators::paint_text() {
  if (unpainted_text_.outline.steps.empty()) return;
  const TextOnPage text = std::exchange(unpainted_text_, {});
  if (text.has_boxes) mark_other();
  const bool had_boxes =
      std::exchange(state_.has_text_boxes, state_.has_text_boxes || text.has_boxes);
  if (state_.text.fills()) fill(text.outline);
  if (state_.text.strokes()) stroke(text.outline);
  state_.has_text_boxes = had_boxes;
}

void ContentOperators::end_text() {
  if (!std::exchange(text_clips_, false)) return;
  const TextOnPage text = std::exchange(clip_text_, {});
  add_to(state_.clips, text.outline);
  state_.has_text_boxes = state_.has_text_boxes || text.has_boxes;
}

}  // namespace gradmesh
