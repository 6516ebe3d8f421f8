#pragma once

#include <string>
#include <vector>

#include "base/clamped_int.h"
#include "formats/pdf/objects/qpdf.h"
#include "formats/pdf/page/content_reader.h"

namespace gradmesh {

/// Follows the operators of one content stream.
class ContentOperators : public QPDFObjectHandle::ParserCallbacks {
 public:
  ContentOperators(ContentReader& reader, QPDFObjectHandle resources, const GraphicsState& state);

  void handleObject(QPDFObjectHandle object, std::size_t, std::size_t) override;
  void handleEOF() override { paint_text(); }

 private:
  using Operator = void (ContentOperators::*)();
  struct Entry;
  static const Entry* find(const std::string& name);

  /// The operand of that number; null, of PDF, if there are not as many.
  QPDFObjectHandle operand(std::size_t n) const;
  double number(std::size_t n) const;
  glm::dvec2 point(std::size_t n) const;
  /// What the last operand names in a category of the resources.
  QPDFObjectHandle named(const char* category) const;

  /// Begin and end content that may belong to a layer.
  void begin_layer();
  void begin_marked() { marked_.push_back(false); }
  void end_marked();
  bool is_hidden() const { return state_.is_hidden || hidden_ > 0; }

  void save();
  void restore();
  void transform();
  void set_state();

  void move_to();
  void line_to();
  void curve_to();
  void curve_from_here();
  void curve_to_there();
  void rectangle();
  void close_path();
  void clip_nonzero() { clip_ = FillRule::nonzero; }
  void clip_evenodd() { clip_ = FillRule::evenodd; }
  void end_path();

  void set_width() { set_line_width(state_.line, operand(0)); }
  void set_cap() { set_line_cap(state_.line, operand(0)); }
  void set_join() { set_line_join(state_.line, operand(0)); }
  void set_miter() { set_miter_limit(state_.line, operand(0)); }
  void set_dash() { set_dashes(state_.line, operand(0), operand(1)); }

  void set_fill_color() { set_color(state_.pattern); }
  void set_stroke_color() { set_color(state_.stroke_pattern); }
  void unset_fill_pattern() { state_.pattern.reset(); }
  void unset_stroke_pattern() { state_.stroke_pattern.reset(); }
  void set_color(std::optional<PagePattern>& pattern);

  template <FillRule rule>
  void fill_path();
  void stroke_path();
  void close_and_stroke();
  template <FillRule rule>
  void fill_and_stroke();
  template <FillRule rule>
  void close_fill_and_stroke();
  /// Paints an area, or the stroke of a path.
  void fill(const PagePath& area);
  void stroke(const PagePath& path);

  void begin_text() { text_place_.begin(); }
  void end_text();
  void set_font();
  void set_text_mode() { state_.text.mode = clamped_int(number(0), 0, 7); }
  void set_character_space() { state_.text.character_space = number(0); }
  void set_word_space() { state_.text.word_space = number(0); }
  void set_text_scale() { state_.text.scale = number(0) / 100; }
  void set_leading() { state_.text.leading = number(0); }
  void set_rise() { state_.text.rise = number(0); }
  void move_line() { text_place_.move_line(point(0)); }
  void move_line_and_set_leading();
  void set_text_matrix() { text_place_.set(map_of_operands()); }
  void next_line() { text_place_.move_line({0, -state_.text.leading}); }
  void show_text() { show(operand(0)); }
  void show_on_next_line();
  void show_spaced_on_next_line();
  void show_texts();
  void show(QPDFObjectHandle text);
  /// Paints the text so far, which is one area whatever it was shown by.
  void paint_text();
  void paint_shading();
  void paint_object();
  /// Notes what is painted beside meshes, if this is a mask.
  void mark_area(const PagePath& area);
  void mark_other();

  void add_step(PagePath::Step::Kind kind, glm::dvec2 a, glm::dvec2 b, glm::dvec2 to);
  Affine map_of_operands() const;
  /// Adds an area to what is seen through.
  static void add_to(Clips& clips, const PagePath& area);
  /// Adds what a pattern paints: a stroke, or the area of the last clip path where that is null.
  void paint_pattern(const PagePattern& pattern, Clips clips, double opacity,
                     std::shared_ptr<const PageStroke> stroke);
  void paint_cell(const PagePattern& pattern, Clips clips, double opacity,
                  std::shared_ptr<const PageStroke> stroke);
  /// Adds a shading, if it is a mesh.
  void paint(PaintedShading painted);

  ContentReader& reader_;
  QPDFObjectHandle resources_;
  const std::shared_ptr<const NamedSpaces> spaces_;
  /// The map at the beginning, in which patterns lie (ISO 32000-1, 8.7.2).
  const Affine base_;
  GraphicsState state_;
  std::vector<GraphicsState> saved_;
  /// For each part of content that is marked, one inside the other, whether it belongs to a layer
  /// that is off; and how many do.
  std::vector<bool> marked_;
  int hidden_ = 0;
  std::vector<QPDFObjectHandle> operands_;
  PagePath path_;
  /// In the coordinates of the content: where the path is, and where its part began.
  glm::dvec2 here_{0.0}, begin_{0.0};
  std::optional<FillRule> clip_;
  TextPlace text_place_;
  /// What was shown of a text and is not painted yet, and through what all will be seen at its end.
  TextOnPage unpainted_text_, clip_text_;
  bool text_clips_ = false;
};

}  // namespace gradmesh
