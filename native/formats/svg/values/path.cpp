#include "formats/svg/values/path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

/// An elliptical arc by its ends, as path data has it.
struct EndArc {
  glm::dvec2 from, to, radii;
  double rotation = 0;  // radians
  bool large = false, sweep = false;
};

/// An elliptical arc by its middle. Angles are those of the circle that the ellipse is made from,
/// seen from the arc's middle: -half at its beginning and half at its end, which is below -half
/// where angles fall along the arc.
///
/// Points are told by their way from the beginning, since the centre may be so far away that its
/// numbers have no digits left for a short or a flat arc.
struct MiddleArc {
  glm::dvec2 from, radii;
  double cos_rotation, sin_rotation;
  /// Direction of the middle on the circle, and half the angle of the arc.
  glm::dvec2 middle;
  double half;

  /// Returns exp(i angle) - exp(-i half), turned to `middle`, on the ellipse: the difference of two
  /// points of a circle is 2 i sin(a) exp(i b) for half the difference a and half the sum b of
  /// their angles.
  glm::dvec2 at(double angle) const {
    const double a = (angle + half) / 2, b = (angle - half) / 2;
    const glm::dvec2 across(-middle.y, middle.x);
    const glm::dvec2 p = 2 * std::sin(a) * radii * (std::cos(b) * across - std::sin(b) * middle);
    return from + glm::dvec2(cos_rotation * p.x - sin_rotation * p.y,
                             sin_rotation * p.x + cos_rotation * p.y);
  }
  /// Returns the angle of a direction on the circle; nothing if the arc does not pass there.
  std::optional<double> angle_of(glm::dvec2 direction) const {
    const double angle =
        std::atan2(middle.x * direction.y - middle.y * direction.x, glm::dot(middle, direction));
    if (std::abs(angle) > std::abs(half)) return std::nullopt;
    return angle;
  }
};

/// Returns the arc by its middle (after SVG 2 appendix B.2); nothing if the arc is a line.
std::optional<MiddleArc> middle_arc(const EndArc& arc) {
  glm::dvec2 r = glm::abs(arc.radii);
  if (arc.from == arc.to || r.x == 0 || r.y == 0) return std::nullopt;
  const double cs = std::cos(arc.rotation), sn = std::sin(arc.rotation);
  const glm::dvec2 chord = (arc.from - arc.to) / 2.0;
  const glm::dvec2 start = glm::dvec2(cs * chord.x + sn * chord.y, -sn * chord.x + cs * chord.y);
  const double stretch = std::hypot(start.x / r.x, start.y / r.y);
  if (stretch > 1) r *= stretch;
  // Half the chord of the circle of radius 1.
  const glm::dvec2 unit = start / r;
  const double sine = std::hypot(unit.x, unit.y);
  // The chord is nothing beside the radii, or these are beyond all numbers.
  if (sine == 0 || !std::isfinite(4 * r.x + 4 * r.y)) return std::nullopt;
  const double small = std::asin(std::min(1.0, sine));
  const double half = arc.large ? std::numbers::pi - small : small;
  const double sign = arc.sweep ? 1 : -1;
  return MiddleArc{arc.from, r, cs, sn, sign * glm::dvec2(-unit.y, unit.x) / sine, sign * half};
}

/// Receives the segments that a reader of path data finds, in order.
class PathSink {
 public:
  virtual ~PathSink() = default;
  virtual void begin(glm::dvec2) {}
  virtual void line(glm::dvec2 from, glm::dvec2 to) = 0;
  virtual void cubic(glm::dvec2 from, glm::dvec2 first, glm::dvec2 second, glm::dvec2 to) = 0;
  virtual void arc(const EndArc& arc) = 0;
};

class BoxSink : public PathSink {
 public:
  void line(glm::dvec2 from, glm::dvec2 to) override {
    box.add(from);
    box.add(to);
  }
  void cubic(glm::dvec2 from, glm::dvec2 first, glm::dvec2 second, glm::dvec2 to) override {
    box.add_cubic(from, first, second, to);
  }
  /// Adds the ends, and those of the ellipse's four extreme points that the arc passes.
  void arc(const EndArc& ends) override {
    line(ends.from, ends.to);
    const auto arc = middle_arc(ends);
    if (!arc) return;
    const glm::dvec2 r = arc->radii;
    const glm::dvec2 rightmost(arc->cos_rotation * r.x, -arc->sin_rotation * r.y);
    const glm::dvec2 lowest(arc->sin_rotation * r.x, arc->cos_rotation * r.y);
    for (const glm::dvec2 direction : {rightmost, -rightmost, lowest, -lowest})
      if (const auto angle = arc->angle_of(direction)) box.add(arc->at(*angle));
  }

  Box box;
};

class OutlineSink : public PathSink {
 public:
  void begin(glm::dvec2 at) override { outline.push_back({at}); }
  void line(glm::dvec2, glm::dvec2 to) override { outline.back().push_back(to); }
  void cubic(glm::dvec2 from, glm::dvec2 first, glm::dvec2 second, glm::dvec2 to) override {
    for (int i = 1; i <= outline_steps; ++i) {
      const double t = double(i) / outline_steps, s = 1 - t;
      outline.back().push_back(s * s * s * from + 3 * s * s * t * first + 3 * s * t * t * second +
                               t * t * t * to);
    }
  }
  void arc(const EndArc& ends) override {
    if (const auto arc = middle_arc(ends))
      for (int i = 1; i < outline_steps; ++i)
        outline.back().push_back(arc->at(arc->half * (2.0 * i / outline_steps - 1)));
    outline.back().push_back(ends.to);
  }

  Outline outline;
};

/// Follows path data and hands its segments on.
class PathReader {
 public:
  PathReader(std::string_view data, PathSink& sink) : scanner_(data), sink_(sink) {}

  /// Reads the data. Returns true if they are well-formed.
  bool read() {
    char command = 0;
    while (!scanner_.at_end()) {
      const char next = scanner_.peek();
      const bool is_letter = (next >= 'a' && next <= 'z') || (next >= 'A' && next <= 'Z');
      if (is_letter) {
        scanner_.accept(next);
        if (command == 0 && next != 'M' && next != 'm') return false;
        command = next;
      } else if (command == 0 || command == 'Z' || command == 'z') {
        return false;
      }
      if (!segment(command)) return false;
      // Further pairs after a moveto are lines.
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
    }
    return true;
  }

 private:
  bool segment(char command) {
    const bool relative = command >= 'a';
    const glm::dvec2 base = relative ? current_ : glm::dvec2(0.0);
    const char kind = relative ? char(command - 'a' + 'A') : command;
    const glm::dvec2 start = current_;
    glm::dvec2 handle = start;
    bool ok = true;
    if (kind != 'M' && kind != 'Z' && !drawing_) {
      sink_.begin(start);
      drawing_ = true;
    }
    switch (kind) {
      case 'M':
        ok = point(base, current_);
        subpath_ = current_;
        handle = current_;
        drawing_ = false;
        break;
      case 'Z':
        current_ = subpath_;
        drawing_ = false;
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
    sink_.line(start, current_);
    handle = current_;
  }

  bool cubic(char kind, glm::dvec2 base, glm::dvec2 start, glm::dvec2& handle) {
    const bool follows = previous_ == 'C' || previous_ == 'S';
    glm::dvec2 first = follows ? 2.0 * start - handle_ : start;
    if (kind == 'C' && !point(base, first)) return false;
    if (!point(base, handle) || !point(base, current_)) return false;
    sink_.cubic(start, first, handle, current_);
    return true;
  }

  bool quadratic(char kind, glm::dvec2 base, glm::dvec2 start, glm::dvec2& handle) {
    const bool follows = previous_ == 'Q' || previous_ == 'T';
    handle = follows ? 2.0 * start - handle_ : start;
    if (kind == 'Q' && !point(base, handle)) return false;
    if (!point(base, current_)) return false;
    sink_.cubic(start, start + (handle - start) * (2.0 / 3.0),
                current_ + (handle - current_) * (2.0 / 3.0), current_);
    return true;
  }

  bool arc(glm::dvec2 base, glm::dvec2 start) {
    EndArc arc;
    double degrees = 0;
    if (!point({0, 0}, arc.radii) || !coordinate(0, degrees)) return false;
    scanner_.skip_comma();
    const auto large = scanner_.flag();
    scanner_.skip_comma();
    const auto sweep = scanner_.flag();
    if (!large || !sweep || !point(base, current_)) return false;
    sink_.arc({start, current_, arc.radii, degrees * std::numbers::pi / 180, *large, *sweep});
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
  PathSink& sink_;
  /// True if the subpath has a segment.
  bool drawing_ = false;
  glm::dvec2 current_{0.0}, subpath_{0.0};
  // Last control point and kind of the segment before, for S and T.
  glm::dvec2 handle_{0.0};
  char previous_ = 0;
};

}  // namespace

std::optional<Box> path_box(std::string_view data) {
  BoxSink sink;
  if (!PathReader(data, sink).read()) return std::nullopt;
  return sink.box;
}

std::optional<Outline> path_outline(std::string_view data) {
  OutlineSink sink;
  if (!PathReader(data, sink).read()) return std::nullopt;
  return std::move(sink.outline);
}

}  // namespace gradmesh
