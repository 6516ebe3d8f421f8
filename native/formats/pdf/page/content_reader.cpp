#include "formats/pdf/page/content_reader.h"

#include <exception>
#include <utility>

#include "base/error.h"
#include "base/limits.h"
#include "formats/pdf/objects/dictionary.h"
#include "formats/pdf/objects/qpdf.h"
#include "formats/pdf/objects/stream_bytes.h"
#include "formats/pdf/page/clip_box.h"
#include "formats/pdf/page/content_operators.h"
#include "formats/pdf/page/lone_groups.h"

namespace gradmesh {
namespace {

bool is_true(QPDFObjectHandle value) { return value.isBool() && value.getBoolValue(); }

}  // namespace

void ContentReader::read(const std::vector<QPDFObjectHandle>& contents,
                         const QPDFObjectHandle& resources, const GraphicsState& state) {
  std::string all;
  for (QPDFObjectHandle each : contents) {
    if (!each.isStream()) continue;
    StreamBytes read = stream_bytes(each);
    is_damaged_ = is_damaged_ || read.is_damaged;
    bytes_ += read.bytes.size();
    const std::uint64_t most = limits().document;
    if (bytes_ > most)
      throw InputError("it shows forms of more than {0} bytes, {1}", most,
                       beyond_limit("document", most, bytes_));
    // Operators may begin in one stream and end in the next, tokens may not (ISO 32000-1, 7.8.2).
    all += read.bytes + "\n";
  }
  ContentOperators operators(*this, resources, state);
  try {
    QPDF none;
    none.setSuppressWarnings(true);
    none.emptyPDF();
    QPDFObjectHandle::parseContentStream(QPDFObjectHandle::newStream(&none, all), &operators);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception&) {
    is_damaged_ = true;
  }
}

void ContentReader::read_form(QPDFObjectHandle form, const QPDFObjectHandle& resources,
                              GraphicsState state) {
  state.is_hidden = state.is_hidden || !layers_.shows(value_of(form, "/OC"));
  state.to_page = state.to_page * matrix_of(value_of(form, "/Matrix"));
  clip_to_box(state.clips, form, state.to_page);
  if (QPDFObjectHandle group = value_of(form, "/Group"); group.isDictionary())
    begin_group(state, {.opacity = state.opacity,
                        .is_isolated = is_true(value_of(group, "/I")),
                        .is_knockout = is_true(value_of(group, "/K"))});
  read_within(form, resources, state);
}

void ContentReader::read_within(QPDFObjectHandle stream, const QPDFObjectHandle& resources,
                                const GraphicsState& state) {
  // Forms that show others twice, and so on, would have no end.
  constexpr int most_forms = 20000;
  const QPDFObjGen number = stream.getObjGen();
  if (around_.contains(number)) return;
  const std::uint64_t most = limits().nesting;
  if (around_.size() >= most)
    throw InputError("its forms are nested {0} deep, {1}", most + 1,
                     beyond_limit("nesting", most, most + 1));
  if (++forms_ > most_forms) throw InputError("it shows more than {0} forms", most_forms);
  const QPDFObjectHandle own = value_of(stream, "/Resources");
  around_.insert(number);
  read({stream}, QPDFObjectHandle(own).isDictionary() ? own : resources, state);
  around_.erase(number);
}

void ContentReader::read_glyph(QPDFObjectHandle glyph, const QPDFObjectHandle& resources,
                               const GraphicsState& state) {
  const bool may_be_plain = !state.pattern && !state.stroke_pattern && !marks_;
  const QPDFObjGen number = glyph.getObjGen();
  if (may_be_plain && plain_glyphs_.contains(number)) return;
  const std::size_t before = painted_.size() + std::size_t(hidden_);
  read_within(glyph, resources, state);
  if (may_be_plain && painted_.size() + std::size_t(hidden_) == before)
    plain_glyphs_.insert(number);
}

std::shared_ptr<PageFont> ContentReader::font(QPDFObjectHandle font) {
  if (!font.isDictionary()) return nullptr;
  // One that is no object of its own has no number by which it could be known again.
  if (!font.isIndirect()) return std::make_shared<PageFont>(font);
  std::shared_ptr<PageFont>& known = fonts_[font.getObjGen()];
  if (!known) known = std::make_shared<PageFont>(font);
  return known;
}

void ContentReader::set_mask(QPDFObjectHandle mask, const QPDFObjectHandle& resources,
                             GraphicsState& state) {
  state.mask = nullptr;
  state.mask_clips.clear();
  state.mask_opacity = 1;
  QPDFObjectHandle form = value_of(mask, "/G");
  if (!form.isStream()) return;
  // The shadings of a mask are found as those of any form, but are not painted.
  std::vector<PaintedShading> painted = std::exchange(painted_, {});
  std::optional<MaskMarks> marks = std::exchange(marks_, MaskMarks());
  const int hidden = hidden_;
  GraphicsState inside;
  inside.to_page = state.to_page;
  read_form(form, resources, inside);
  painted.swap(painted_);
  std::swap(marks, marks_);
  hidden_ = hidden;
  const bool is_alpha = value_of(mask, "/S").isNameAndEquals("/Alpha");
  QPDFObjectHandle transfer = value_of(mask, "/TR");
  const bool is_changed = !transfer.isNull() && !transfer.isNameAndEquals("/Identity");
  const auto area = is_alpha && !is_changed && painted.empty() ? area_of(*marks) : std::nullopt;
  if (area) {
    state.mask_clips = area->clips;
    state.mask_opacity = area->opacity;
    return;
  }
  leave_lone_groups(painted);
  // Whoever finds no shadings in it says that it is left out.
  if (is_alpha || is_changed) painted.clear();
  state.mask = std::make_shared<const std::vector<PaintedShading>>(std::move(painted));
}

}  // namespace gradmesh
