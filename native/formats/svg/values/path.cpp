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

constexpr double full_turn = 2 * std::numbers::pi;

/// An elliptical arc by its centre: the points center + turn(r * (cos a, sin a)) for a from `begin`
/// over `extent`.
struct CenterArc {
  glm::dvec2 center, radii;
  double cos_rotation, sin_rotation, begin, extent;
  /// True if angles grow along the arc.
  bool sweep;

  glm::dvec2 at(double angle) const {
    const glm::dvec2 p = radii * glm::dvec2(std::cos(angle), std::sin(angle));
    return center + glm::dvec2(cos_rotation * p.x - sin_rotation * p.y,
                               sin_rotation * p.x + cos_rotation * p.y);
  }
  /// Returns how far the angle lies from the beginning, in the arc's direction.
  double way_to(double angle) const {
    const double way = std::fmod(sweep ? angle - begin : begin - angle, full_turn);
    return way < 0 ? way + full_turn : way;
  }
};

/// Returns the arc by its centre (SVG 2 appendix B.2); nothing if the arc is a line, or has a chord
/// so short that it is one but for rounding.
std::optional<CenterArc> center_arc(const EndArc& arc) {
  glm::dvec2 r = glm::abs(arc.radii);
  if (arc.from == arc.to || r.x == 0 || r.y == 0) return std::nullopt;
  const double cs = std::cos(arc.rotation), sn = std::sin(arc.rotation);
  const glm::dvec2 half = (arc.from - arc.to) / 2.0;
  const glm::dvec2 start = glm::dvec2(cs * half.x + sn * half.y, -sn * half.x + cs * half.y);

  const glm::dvec2 ratio = start / r;
  const double stretch = glm::dot(ratio, ratio);
  if (stretch > 1) r *= std::sqrt(stretch);
  // In the unit circle's coordinates: the chord's half is `unit`, the centre lies off its middle.
  const glm::dvec2 unit = start / r;
  const double square = glm::dot(unit, unit);
  // The square of a chord that is hardly there may have no digits, or be 0.
  const bool has_digits = square >= std::numeric_limits<double>::min();
  double off =
      has_digits ? std::sqrt(std::max(0.0, 1 / square - 1)) : 1 / std::hypot(unit.x, unit.y);
  if (!std::isfinite(off)) return std::nullopt;
  if (arc.large == arc.sweep) off = -off;
  const glm::dvec2 center = off * glm::dvec2(unit.y, -unit.x);
  const glm::dvec2 first = unit - center, last = -unit - center;
  constexpr double short_chord = 1e-9;
  if (first == last || (!arc.large && square < short_chord * short_chord)) return std::nullopt;

  CenterArc result{{0, 0}, r, cs, sn, std::atan2(first.y, first.x), 0, arc.sweep};
  const glm::dvec2 scaled = center * r;
  result.center = (arc.from + arc.to) / 2.0 +
                  glm::dvec2(cs * scaled.x - sn * scaled.y, sn * scaled.x + cs * scaled.y);
  result.extent = result.way_to(std::atan2(last.y, last.x));
  // Ends that only rounding tells apart: the large arc is the whole ellipse, and not nothing of it.
  if (arc.large && result.extent < std::numbers::pi) result.extent = full_turn;
  return result;
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
    const auto arc = center_arc(ends);
    if (!arc) return;
    const double x_extreme =
        std::atan2(-arc->sin_rotation * arc->radii.y, arc->cos_rotation * arc->radii.x);
    const double y_extreme =
        std::atan2(arc->cos_rotation * arc->radii.y, arc->sin_rotation * arc->radii.x);
    for (const double angle :
         {x_extreme, x_extreme + std::numbers::pi, y_extreme, y_extreme + std::numbers::pi})
      if (arc->way_to(angle) <= arc->extent) box.add(arc->at(angle));
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
    if (const auto arc = center_arc(ends))
      for (int i = 1; i < outline_steps; ++i) {
        const double way = arc->extent * i / outline_steps;
        outline.back().push_back(arc->at(arc->begin + (arc->sweep ? way : -way)));
      }
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
