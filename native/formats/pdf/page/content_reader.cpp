#include "formats/pdf/page/content_reader.h"

#include <exception>

#include "base/error.h"
#include "base/limits.h"
#include "formats/pdf/page/clip_box.h"
#include "formats/pdf/page/content_operators.h"
#include "formats/pdf/page/dictionary.h"
#include "formats/pdf/page/qpdf.h"
#include "formats/pdf/page/stream_bytes.h"

namespace gradmesh {

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
  // Forms that show others twice, and so on, would have no end.
  constexpr int most_forms = 20000;
  const QPDFObjGen number = form.getObjGen();
  if (around_.contains(number)) return;
  const std::uint64_t most = limits().nesting;
  if (around_.size() >= most)
    throw InputError("its forms are nested {0} deep, {1}", most + 1,
                     beyond_limit("nesting", most, most + 1));
  if (++forms_ > most_forms) throw InputError("it shows more than {0} forms", most_forms);
  state.to_page = state.to_page * matrix_of(value_of(form, "/Matrix"));
  clip_to_box(state.clips, form, state.to_page);
  if (value_of(form, "/Group").isDictionary()) {
    state.group_opacity *= state.opacity;
    state.opacity = state.stroke_opacity = 1;
    if (state.blend_mode != "normal") state.group_blend_mode = state.blend_mode;
    state.blend_mode = "normal";
  }
  const QPDFObjectHandle own = value_of(form, "/Resources");
  around_.insert(number);
  read({form}, QPDFObjectHandle(own).isDictionary() ? own : resources, state);
  around_.erase(number);
}

std::shared_ptr<const std::vector<PaintedShading>> ContentReader::mask_of(
    QPDFObjectHandle mask, const QPDFObjectHandle& resources, const GraphicsState& state) {
  QPDFObjectHandle form = value_of(mask, "/G");
  if (!value_of(mask, "/S").isNameAndEquals("/Luminosity") || !form.isStream()) return nullptr;
  // The shadings of a mask are found as those of any form, but are not painted.
  std::vector<PaintedShading> painted;
  painted.swap(painted_);
  GraphicsState inside;
  inside.to_page = state.to_page;
  read_form(form, resources, inside);
  painted.swap(painted_);
  return std::make_shared<const std::vector<PaintedShading>>(std::move(painted));
}

}  // namespace gradmesh
