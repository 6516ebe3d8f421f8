#pragma once

#include <string>
#include <vector>

#include "base/clamped_int.h"
#include "formats/pdf/page/content_reader.h"
#include "formats/pdf/page/qpdf.h"

namespace gradmesh {

/// Follows the operators of one content stream.
class ContentOperators : public QPDFObjectHandle::ParserCallbacks {
 public:
  ContentOperators(ContentReader& reader, QPDFObjectHandle resources, const GraphicsState& state);

  void handleObject(QPDFObjectHandle object, std::size_t, std::size_t) override;
  void handleEOF() override {}

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
  void set_color(std::optional<QPDFObjectHandle>& pattern);

  template <FillRule rule>
  void fill_path();
  void stroke_path();
  void close_and_stroke();
  template <FillRule rule>
  void fill_and_stroke();
  template <FillRule rule>
  void close_fill_and_stroke();
  /// Paints the area of the path, or its stroke, and keeps it for what else is done with it.
  void fill(FillRule rule);
  void stroke();
  void set_text_mode() { state_.text_mode = clamped_int(number(0), 0, 7); }
  void begin_text() { text_clips_ = false; }
  void show_text();
  void end_text();
  void paint_shading();
  void paint_object();
  /// Notes what is painted beside meshes, if this is a mask.
  void mark_area(FillRule rule);
  void mark_other();

  void add_step(PagePath::Step::Kind kind, glm::dvec2 a, glm::dvec2 b, glm::dvec2 to);
  /// Adds the path to what is seen through.
  void add_to(Clips& clips, FillRule rule);
  /// Adds what a pattern paints: a stroke, or the area of the last clip path where that is null.
  void paint_pattern(QPDFObjectHandle pattern, Clips clips, double opacity,
                     std::shared_ptr<const PageStroke> stroke);
  void paint_cell(QPDFObjectHandle pattern, Clips clips, double opacity,
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
  /// Whether what was shown of the text is seen through.
  bool text_clips_ = false;
};

}  // namespace gradmesh
