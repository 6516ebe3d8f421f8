#include "draw/legend.h"

#include <algorithm>
#include <cmath>

#include "base/clamped_int.h"
#include "base/power_of_ten.h"
#include "formats/text/number.h"

namespace gradmesh {
namespace {

constexpr const char* ink = "#1d1d24";
/// Size of text, and its distance from the start of a sample, in Subject::unit().
constexpr double font = 2.2, indent = 5.6;

}  // namespace

Legend::Legend(const Subject& subject, const Drawing& drawing, const std::string& heading)
    : subject_(subject),
      unit_(subject.unit()),
      start_(drawing.box.high().x + unit_, drawing.box.low().y + 3 * unit_),
      y_(start_.y),
      right_(start_.x) {
  layer_.name = subject.say(Message("Legend"));
  y_ += font * unit_;
  add_label({start_.x, y_}, heading, true);
}

void Legend::add_label(glm::dvec2 at, const std::string& text, bool bold, Anchor anchor) {
  layer_.labels.push_back({text, at, font * unit_, ink, anchor, bold});
  // Wide enough for the usual sans-serif typefaces.
  const double width = (bold ? 0.66 : 0.6) * font * unit_ * double(text.size());
  right_ = std::max(right_, anchor == Anchor::end ? at.x : at.x + width);
}

void Legend::text(const std::string& text) {
  y_ += line_height();
  add_label({start_.x, y_}, text);
}

glm::dvec2 Legend::next_sample(const std::string& text) {
  y_ += line_height();
  add_label({start_.x + indent * unit_, y_}, text);
  return {start_.x + 2 * unit_, y_ - 0.35 * font * unit_};
}

void Legend::add_mark(const PathText& path, const Style& style) {
  layer_.shapes.push_back({path.text(), style, ""});
}

void Legend::line(const Style& style, const std::string& text) {
  const glm::dvec2 at = next_sample(text);
  PathText path{Affine{}};
  path.move(at - glm::dvec2(2 * unit_, 0));
  path.line(at + glm::dvec2(2 * unit_, 0));
  add_mark(path, style);
}

void Legend::area(const Style& style, const std::string& text) {
  const glm::dvec2 at = next_sample(text), half = unit_ * glm::dvec2(2, 1.1);
  PathText path{Affine{}};
  path.move(at - half);
  path.line(at + glm::dvec2(half.x, -half.y));
  path.line(at + half);
  path.line(at + glm::dvec2(-half.x, half.y));
  path.close();
  add_mark(path, style);
}

void Legend::circle(const Style& style, const std::string& text) {
  PathText path{Affine{}};
  path.circle(next_sample(text), 0.5 * unit_);
  add_mark(path, style);
}

void Legend::diamond(const Style& style, const std::string& text) {
  PathText path{Affine{}};
  path.diamond(next_sample(text), 0.8 * unit_);
  add_mark(path, style);
}

void Legend::entry(const std::array<std::string, 3>& columns, bool shown) {
  y_ += line_height();
  add_label({start_.x + indent * unit_, y_}, columns[0], shown, Anchor::end);
  add_label({start_.x + (indent + 1.6) * unit_, y_}, columns[1], shown);
  add_label({start_.x + (indent + 12) * unit_, y_}, columns[2], shown);
  if (!shown) return;
  const glm::dvec2 at(start_.x + unit_, y_ - 0.35 * font * unit_);
  PathText path{Affine{}};
  path.move(at + unit_ * glm::dvec2(-1, -0.8));
  path.line(at);
  path.line(at + unit_ * glm::dvec2(-1, 0.8));
  path.close();
  add_mark(path, {.fill = ink});
}

void Legend::scale(const HeatScale& scale, double least) {
  constexpr int steps = 60;
  const double width = 3.4 * unit_, height = 36 * unit_, top = y_ + line_height();
  const auto y_at = [&](double position) { return top + height * (1 - position); };
  for (int i = 0; i < steps; ++i) {
    // Each piece reaches below the one that follows, so that no seam shows.
    const double low = std::max(0.0, (i - 0.5) / steps), high = double(i + 1) / steps;
    PathText path{Affine{}};
    path.move({start_.x, y_at(low)});
    path.line({start_.x + width, y_at(low)});
    path.line({start_.x + width, y_at(high)});
    path.line({start_.x, y_at(high)});
    path.close();
    layer_.shapes.insert(layer_.shapes.begin(),
                         {path.text(), {.fill = HeatScale::color_at((i + 0.5) / steps)}, ""});
  }
  const auto tick = [&](double position, const std::string& text) {
    PathText path{Affine{}};
    path.move({start_.x + width, y_at(position)});
    path.line({start_.x + width + unit_, y_at(position)});
    add_mark(path, {.stroke = ink, .stroke_width = 0.2 * unit_});
    add_label({start_.x + indent * unit_, y_at(position) + 0.35 * font * unit_}, text);
  };
  tick(1, subject_.say(Message("{0} (largest)", short_number(scale.highest()))));
  const std::string lowest = short_number(scale.lowest());
  tick(0, least < scale.lowest() ? subject_.say(Message("{0} and less", lowest)) : lowest);
  const int first = clamped_int(std::ceil(std::log10(scale.lowest())), -400, 400);
  for (int power = first; power < std::log10(scale.highest()); ++power) {
    const double position = scale.position(power_of_ten(power));
    // The ends have their own numbers, which must stay legible.
    if (position > 0.08 && position < 0.92) tick(position, short_number(power_of_ten(power)));
  }
  y_ = top + height + 0.5 * line_height();
  text(subject_.say(Message("Least: {0}", short_number(least))));
}

void Legend::add_to(Drawing& drawing) && {
  drawing.box.add({right_ + 2 * unit_, y_ + 2 * unit_});
  drawing.layers.push_back(std::move(layer_));
}

std::string short_number(double value) {
  return std::abs(value) < 5e-17 ? "0" : format_number(value, 2);
}

}  // namespace gradmesh
