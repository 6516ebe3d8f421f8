#include "io/svg_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "io/svg_scanner.h"

namespace gradmesh {
namespace {

/// An elliptical arc by its ends, as path data has it.
struct Arc {
  glm::dvec2 from, to, radii;
  double rotation = 0;  // radians
  bool large = false, sweep = false;
};

/// Conversion to centre and angles, SVG 2 appendix B.2; then the ends and those of the ellipse's
/// four extreme points that the arc passes.
void add_arc(Box& box, const Arc& arc) {
  box.add(arc.from);
  box.add(arc.to);
  glm::dvec2 r = glm::abs(arc.radii);
  if (arc.from == arc.to || r.x == 0 || r.y == 0) return;
  const double cs = std::cos(arc.rotation), sn = std::sin(arc.rotation);
  const auto turn = [&](glm::dvec2 p) {
    return glm::dvec2(cs * p.x - sn * p.y, sn * p.x + cs * p.y);
  };
  const glm::dvec2 half = (arc.from - arc.to) / 2.0;
  const glm::dvec2 start = glm::dvec2(cs * half.x + sn * half.y, -sn * half.x + cs * half.y);

  const glm::dvec2 ratio = start / r;
  const double stretch = glm::dot(ratio, ratio);
  if (stretch > 1) r *= std::sqrt(stretch);
  // In the unit circle's coordinates: the chord's half is `unit`, the centre lies off its middle.
  const glm::dvec2 unit = start / r;
  const double square = glm::dot(unit, unit);
  double off = std::sqrt(std::max(0.0, 1 / square - 1));
  if (arc.large == arc.sweep) off = -off;
  const glm::dvec2 center = off * glm::dvec2(unit.y, -unit.x);
  const glm::dvec2 first = unit - center, last = -unit - center;

  const glm::dvec2 middle = (arc.from + arc.to) / 2.0 + turn(center * r);
  const double begin = std::atan2(first.y, first.x);
  constexpr double full = 2 * std::numbers::pi;
  const auto angle_from_begin = [&](double angle) {
    double way = std::fmod(arc.sweep ? angle - begin : begin - angle, full);
    return way < 0 ? way + full : way;
  };
  const double extent = angle_from_begin(std::atan2(last.y, last.x));
  const double x_extreme = std::atan2(-sn * r.y, cs * r.x);
  const double y_extreme = std::atan2(cs * r.y, sn * r.x);
  for (const double angle :
       {x_extreme, x_extreme + std::numbers::pi, y_extreme, y_extreme + std::numbers::pi})
    if (angle_from_begin(angle) <= extent)
      box.add(middle + turn(r * glm::dvec2(std::cos(angle), std::sin(angle))));
}

/// Follows path data and collects its box.
class PathReader {
 public:
  explicit PathReader(std::string_view data) : scanner_(data) {}

  std::optional<Box> read() {
    if (scanner_.at_end()) return box_;
    char command = 0;
    while (!scanner_.at_end()) {
      const char next = scanner_.peek();
      const bool is_letter = (next >= 'a' && next <= 'z') || (next >= 'A' && next <= 'Z');
      if (is_letter) {
        scanner_.accept(next);
        if (command == 0 && next != 'M' && next != 'm') return std::nullopt;
        command = next;
      } else if (command == 0 || command == 'Z' || command == 'z') {
        return std::nullopt;
      }
      if (!segment(command)) return std::nullopt;
      // Further pairs after a moveto are lines.
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
    }
    return box_;
  }

 private:
  bool segment(char command) {
    const bool relative = command >= 'a';
    const glm::dvec2 base = relative ? current_ : glm::dvec2(0.0);
    const char kind = relative ? char(command - 'a' + 'A') : command;
    const glm::dvec2 start = current_;
    glm::dvec2 handle = start;
    bool ok = true;
    switch (kind) {
      case 'M':
        ok = point(base, current_);
        subpath_ = current_;
        handle = current_;
        break;
      case 'Z':
        current_ = subpath_;
        handle = current_;
        break;
      case 'L':
        ok = point(base, current_);
        line(start, handle);
        break;
      case 'H':
        ok = coordinate(base.x, current_.x);
        line(start, handle);
        break;
      case 'V':
        ok = coordinate(base.y, current_.y);
        line(start, handle);
        break;
      case 'C':
      case 'S':
        ok = cubic(kind, base, start, handle);
        break;
      case 'Q':
      case 'T':
        ok = quadratic(kind, base, start, handle);
        break;
      case 'A':
        ok = arc(base, start);
        handle = current_;
        break;
      default:
        return false;
    }
    handle_ = handle;
    previous_ = kind;
    return ok;
  }

  void line(glm::dvec2 start, glm::dvec2& handle) {
    box_.add(start);
    box_.add(current_);
    handle = current_;
  }

  bool cubic(char kind, glm::dvec2 base, glm::dvec2 start, glm::dvec2& handle) {
    const bool follows = previous_ == 'C' || previous_ == 'S';
    glm::dvec2 first = follows ? 2.0 * start - handle_ : start;
    if (kind == 'C' && !point(base, first)) return false;
    if (!point(base, handle) || !point(base, current_)) return false;
    box_.add_cubic(start, first, handle, current_);
    return true;
  }

  bool quadratic(char kind, glm::dvec2 base, glm::dvec2 start, glm::dvec2& handle) {
    const bool follows = previous_ == 'Q' || previous_ == 'T';
    handle = follows ? 2.0 * start - handle_ : start;
    if (kind == 'Q' && !point(base, handle)) return false;
    if (!point(base, current_)) return false;
    box_.add_cubic(start, start + (handle - start) * (2.0 / 3.0),
                   current_ + (handle - current_) * (2.0 / 3.0), current_);
    return true;
  }

  bool arc(glm::dvec2 base, glm::dvec2 start) {
    Arc arc;
    double degrees = 0;
    if (!point({0, 0}, arc.radii) || !coordinate(0, degrees)) return false;
    scanner_.skip_comma();
    const auto large = scanner_.flag();
    scanner_.skip_comma();
    const auto sweep = scanner_.flag();
    if (!large || !sweep || !point(base, current_)) return false;
    add_arc(box_, {start, current_, arc.radii, degrees * std::numbers::pi / 180, *large, *sweep});
    return true;
  }

  bool coordinate(double base, double& result) {
    scanner_.skip_comma();
    const auto number = scanner_.number();
    if (number) result = base + *number;
    return number.has_value();
  }

  bool point(glm::dvec2 base, glm::dvec2& result) {
    return coordinate(base.x, result.x) && coordinate(base.y, result.y);
  }

  Scanner scanner_;
  Box box_;
  glm::dvec2 current_{0.0}, subpath_{0.0};
  // Last control point and kind of the segment before, for S and T.
  glm::dvec2 handle_{0.0};
  char previous_ = 0;
};

}  // namespace

std::optional<Box> path_box(std::string_view data) { return PathReader(data).read(); }

}  // namespace gradmesh
