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
  void fill_nonzero() { fill(FillRule::nonzero); }
  void fill_evenodd() { fill(FillRule::evenodd); }
  void fill(FillRule rule);
  void end_path();

  void set_color();
  void unset_pattern() { state_.pattern.reset(); }
  void paint_shading();
  void paint_object();

  void add_step(PagePath::Step::Kind kind, glm::dvec2 a, glm::dvec2 b, glm::dvec2 to);
  /// Adds the path to what is seen through.
  void add_to(Clips& clips, FillRule rule);
  void paint(QPDFObjectHandle shading, const Affine& to_page, Clips clips);

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
