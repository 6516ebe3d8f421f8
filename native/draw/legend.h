#pragma once

#include <array>
#include <string>

#include "draw/drawing.h"
#include "draw/heat_scale.h"
#include "draw/subject.h"

namespace gradmesh {

/// The legend in a column to the right of a drawing, one line below the other. The subject must
/// outlive the legend.
class Legend {
 public:
  Legend(const Subject& subject, const Drawing& drawing, const std::string& heading);

  void text(const std::string& text);
  void gap() { y_ += 0.5 * line_height(); }
  /// Adds a sample and its meaning.
  void line(const Style& style, const std::string& text);
  void area(const Style& style, const std::string& text);
  void circle(const Style& style, const std::string& text);
  void diamond(const Style& style, const std::string& text);
  /// Adds a line of a list in three columns, emphasized if `shown`.
  void entry(const std::array<std::string, 3>& columns, bool shown);
  /// Adds a bar with ticks at the powers of ten, and the least and the largest error beside it.
  void scale(const HeatScale& scale, double least);

  /// Makes room for the column and adds it as the topmost layer.
  void add_to(Drawing& drawing) &&;

 private:
  double line_height() const { return 3.4 * unit_; }
  void add_label(glm::dvec2 at, const std::string& text, bool bold = false,
                 Anchor anchor = Anchor::start);
  /// Goes to the next line. Returns the middle of the place for its sample.
  glm::dvec2 next_sample(const std::string& text);
  void add_mark(const PathText& path, const Style& style);

  const Subject& subject_;
  double unit_;
  glm::dvec2 start_;
  double y_;
  double right_;
  Layer layer_;
};

/// Returns a number for people: "0.0012", "4.1e-06".
std::string short_number(double value);

}  // namespace gradmesh
