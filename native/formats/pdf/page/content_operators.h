#pragma once

#include <string>
#include <vector>

#include "formats/pdf/page/content_reader.h"
#include "formats/pdf/page/qpdf.h"

namespace gradmesh {

/// Follows the operators of one content stream.
class ContentOperators : public QPDFObjectHandle::ParserCallbacks {
 public:
  ContentOperators(ContentReader& reader, QPDFObjectHandle resources, const GraphicsState& state)
      : reader_(reader), resources_(std::move(resources)), base_(state.to_page), state_(state) {}

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
  void paint_shading();
  void paint_object();

  void add_step(PagePath::Step::Kind kind, glm::dvec2 a, glm::dvec2 b, glm::dvec2 to);
  /// Adds the path to what is seen through.
  void add_to(Clips& clips, FillRule rule);
  /// Adds what a pattern paints: a stroke, or an area where that is null.
  void paint_pattern(QPDFObjectHandle pattern, Clips clips, double opacity,
                     std::shared_ptr<const PageStroke> stroke);
  /// Adds a shading, if it is a mesh.
  void paint(PaintedShading painted);

  ContentReader& reader_;
  QPDFObjectHandle resources_;
  /// The map at the beginning, in which patterns lie (ISO 32000-1, 8.7.2).
  const Affine base_;
  GraphicsState state_;
  std::vector<GraphicsState> saved_;
  std::vector<QPDFObjectHandle> operands_;
  PagePath path_;
  /// In the coordinates of the content: where the path is, and where its part began.
  glm::dvec2 here_{0.0}, begin_{0.0};
  std::optional<FillRule> clip_;
};

}  // namespace gradmesh
