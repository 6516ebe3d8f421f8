#pragma once

#include <memory>
#include <string>
#include <vector>

#include "formats/pdf/text/page_font.h"

namespace gradmesh {

/// How text is shown (ISO 32000-1, 9.3).
struct TextStyle {
  std::shared_ptr<PageFont> font;
  double size = 0;
  double character_space = 0, word_space = 0, leading = 0, rise = 0;
  /// 1 for glyphs as wide as they are.
  double scale = 1;
  int mode = 0;

  bool fills() const { return mode % 4 == 0 || mode % 4 == 2; }
  bool strokes() const { return mode % 4 == 1 || mode % 4 == 2; }
  bool clips() const { return mode >= 4; }
};

/// What a text shows, where it shows it.
struct TextOnPage {
  /// In page coordinates.
  PagePath outline;
  /// Whether boxes stand for some glyphs, as the document does not hold their outlines.
  bool has_boxes = false;
  /// Glyphs that are contents of their own, with the maps from their coordinates to the page's.
  struct Content {
    QPDFObjectHandle content;
    Affine to_page;
  };
  std::vector<Content> contents;
};

/// Where the next glyph of a text object comes (ISO 32000-1, 9.4).
class TextPlace {
 public:
  void begin() { set({}); }
  void set(const Affine& matrix) { line_ = glyph_ = matrix; }
  /// Begins another line, so far from the beginning of this one.
  void move_line(glm::dvec2 by) { set(line_ * Affine::translation(by)); }
  /// Leaves as much room as a number between texts says, which are thousandths of an em.
  void leave_room(double thousandths, const TextStyle& style);
  /// Returns what the glyphs of a text show, and moves on behind them. Without `outlines` these are
  /// left out, which takes less time.
  TextOnPage show(const std::string& text, const TextStyle& style, const Affine& to_page,
                  bool outlines);

 private:
  void show_glyph(const PageFont::Glyph& glyph, const TextStyle& style, const Affine& to_page,
                  bool outlines, TextOnPage& shown);

  Affine line_, glyph_;
};

/// Adds a path, with its points mapped.
void append(PagePath& path, const PagePath& other, const Affine& map = {});

}  // namespace gradmesh
