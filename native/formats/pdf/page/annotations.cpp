#include "formats/pdf/page/annotations.h"

#include <optional>
#include <set>
#include <string>

#include "base/clamped_int.h"
#include "formats/pdf/objects/dictionary.h"
#include "geom/box.h"

namespace gradmesh {
namespace {

/// Flags of an annotation that is not seen on a screen (ISO 32000-1, table 165).
constexpr int hidden = 1 << 1, no_view = 1 << 5;

bool is_shown(QPDFObjectHandle annotation) {
  if (!annotation.isDictionary()) return false;
  // A popup is shown by viewers as a window of their own.
  if (value_of(annotation, "/Subtype").isNameAndEquals("/Popup")) return false;
  const int flags =
      clamped_int(number_of(value_of(annotation, "/F")).value_or(0), 0, (1 << 16) - 1);
  return (flags & (hidden | no_view)) == 0;
}

/// Returns the form that an annotation shows now: the one for its state, where there are several.
/// Without a state it is, as poppler has it, the only one, or else that for "Off".
QPDFObjectHandle appearance_of(QPDFObjectHandle annotation) {
  QPDFObjectHandle normal = value_of(value_of(annotation, "/AP"), "/N");
  if (normal.isStream()) return normal;
  QPDFObjectHandle state = value_of(annotation, "/AS");
  if (state.isName()) return value_of(normal, state.getName());
  const auto states = normal.isDictionary() ? normal.getKeys() : std::set<std::string>();
  return value_of(normal, states.size() == 1 ? *states.begin() : "/Off");
}

std::optional<Box> box_of(QPDFObjectHandle object, const Affine& map = {}) {
  const std::vector<double> n = numbers_of(object);
  if (n.size() != 4) return {};
  Box box;
  for (const glm::dvec2 corner : {glm::dvec2(n[0], n[1]), {n[2], n[1]}, {n[2], n[3]}, {n[0], n[3]}})
    box.add(map.point(corner));
  return box;
}

}  // namespace

std::vector<QPDFObjectHandle> annotations_of(QPDFPageObjectHelper page) {
  std::vector<QPDFObjectHandle> shown;
  QPDFObjectHandle all = value_of(page.getObjectHandle(), "/Annots");
  if (!all.isArray()) return shown;
  for (QPDFObjectHandle annotation : all.getArrayAsVector())
    if (is_shown(annotation)) shown.push_back(annotation);
  return shown;
}

void read_annotation(ContentReader& reader, QPDFObjectHandle annotation, GraphicsState page) {
  QPDFObjectHandle form = appearance_of(annotation);
  if (!form.isStream()) return;
  // The box of the form, as its matrix turns it, is put over the rectangle.
  const auto to = box_of(value_of(annotation, "/Rect"));
  const auto from = box_of(value_of(form, "/BBox"), matrix_of(value_of(form, "/Matrix")));
  if (!to || !from || !(from->size().x > 0) || !(from->size().y > 0)) return;
  const glm::dvec2 scale = to->size() / from->size();
  page.to_page = page.to_page * Affine::translation(to->low()) * Affine::scaling(scale) *
                 Affine::translation(-from->low());
  page.is_hidden = page.is_hidden || !reader.layers().shows(value_of(annotation, "/OC"));
  reader.read_form(form, QPDFObjectHandle::newNull(), std::move(page));
}

}  // namespace gradmesh
