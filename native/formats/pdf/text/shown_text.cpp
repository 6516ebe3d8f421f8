#include "formats/pdf/text/shown_text.h"

namespace gradmesh {
namespace {

/// Where lines run down: what lies between the origins of a glyph for both directions, and how far
/// the next glyph is, unless a font says otherwise (ISO 32000-1, 9.7.4.3), which is not read.
constexpr double vertical_origin = 0.88, vertical_advance = -1;

}  // namespace

void append(PagePath& path, const PagePath& other, const Affine& map) {
  for (PagePath::Step step : other.steps) {
    for (glm::dvec2& point : step.points) point = map.point(point);
    path.steps.push_back(step);
  }
}

void TextPlace::leave_room(double thousandths, const TextStyle& style) {
  const double by = -thousandths / 1000 * style.size;
  const bool is_vertical = style.font && style.font->is_vertical();
  glyph_ = glyph_ *
           Affine::translation(is_vertical ? glm::dvec2(0, by) : glm::dvec2(by * style.scale, 0));
}

TextOnPage TextPlace::show(const std::string& text, const TextStyle& style, const Affine& to_page,
                           bool outlines) {
  TextOnPage shown;
  if (!style.font) return shown;
  for (const PageFont::Glyph& glyph : style.font->glyphs_of(text)) {
    show_glyph(glyph, style, to_page, outlines, shown);
    const double space = style.character_space + (glyph.is_space ? style.word_space : 0);
    const glm::dvec2 by = style.font->is_vertical()
                              ? glm::dvec2(0, vertical_advance * style.size + space)
                              : glm::dvec2((glyph.advance * style.size + space) * style.scale, 0);
    glyph_ = glyph_ * Affine::translation(by);
  }
  return shown;
}

void TextPlace::show_glyph(const PageFont::Glyph& glyph, const TextStyle& style,
                           const Affine& to_page, bool outlines, TextOnPage& shown) {
  PageFont& font = *style.font;
  const Affine ems{glm::dmat2(style.size * style.scale, 0, 0, style.size), {0, style.rise}};
  Affine map = to_page * glyph_ * ems;
  if (font.is_vertical()) map = map * Affine::translation({-0.5 * glyph.advance, -vertical_origin});
  if (font.is_of_contents()) {
    if (QPDFObjectHandle content = font.content(glyph.code); content.isStream())
      shown.contents.push_back({content, map * font.matrix()});
  } else if (!outlines) {
    return;
  } else if (const auto outline = font.outline(glyph.code)) {
    append(shown.outline, *outline, map);
  } else if (!glyph.is_space) {
    append(shown.outline, font.box(glyph), map);
    shown.has_boxes = true;
  }
}

}  // namespace gradmesh
