#include "session/pointing.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "base/clamped_int.h"
#include "geom/box.h"
#include "geom/outline.h"
#include "mesh/face_outline.h"

namespace gradmesh {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The element that is closest of those within reach; of several that are as close the last.
template <class Element>
struct Nearest {
  explicit Nearest(double reach) : distance(reach) {}

  void take(Element element, double its_distance) {
    if (its_distance > distance) return;
    distance = its_distance;
    found = element;
  }

  double distance;
  Element found{};
};

double distance_to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 along = b - a;
  const double square = glm::dot(along, along);
  const double t = square > 0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0;
  return glm::length(p - (a + t * along));
}

double distance_to_curve(glm::dvec2 place, const std::vector<glm::dvec2>& points) {
  double least = infinity;
  for (std::size_t i = 1; i < points.size(); ++i)
    least = std::min(least, distance_to_segment(place, points[i - 1], points[i]));
  return least;
}

struct Closest {
  double distance = infinity, along_top = 0, along_left = 0;
};

/// Returns the point of a patch that is closest to a place, from samples on in ever smaller steps.
Closest closest_in(const Patch& patch, const Affine& to_pixels, glm::dvec2 place) {
  constexpr int samples = 8;
  constexpr double fine = 1e-4;
  Closest best;
  const auto try_at = [&](double v, double u) {
    if (u < 0 || u > 1 || v < 0 || v > 1) return false;
    const double distance =
        glm::length(to_pixels.point(glm::dvec2(patch.at(u, v).position)) - place);
    if (distance >= best.distance) return false;
    best = {distance, v, u};
    return true;
  };
  for (int i = 0; i <= samples; ++i)
    for (int j = 0; j <= samples; ++j) try_at(double(i) / samples, double(j) / samples);
  for (double step = 0.5 / samples; step > fine;) {
    const Closest at = best;
    bool is_closer = false;
    for (const int i : {-1, 0, 1})
      for (const int j : {-1, 0, 1})
        is_closer |= try_at(at.along_top + i * step, at.along_left + j * step);
    if (!is_closer) step /= 2;
  }
  return best;
}

/// Returns how far a place is from a box around a patch, and so at least from the patch.
double distance_to_box(const Patch& patch, const Affine& to_pixels, glm::dvec2 place) {
  Box box;
  for (const auto& row : bezier_net(patch))
    for (const Value& point : row) box.add(to_pixels.point(point.position));
  return glm::distance(place, glm::clamp(place, box.low(), box.high()));
}

/// Returns how much of a patch lies inside an area, 0 to 1.
double share_inside(const Patch& patch, const Affine& to_pixels, const FilledOutline& area) {
  constexpr int samples = 9;
  int inside = 0;
  for (int i = 0; i < samples; ++i)
    for (int j = 0; j < samples; ++j) {
      const Value at = patch.at((i + 0.5) / samples, (j + 0.5) / samples);
      inside += contains(area, to_pixels.point(at.position));
    }
  return double(inside) / (samples * samples);
}

/// Returns points of a line that are at most half a pixel apart.
std::vector<glm::dvec2> pixels_along(const std::vector<glm::dvec2>& line) {
  constexpr int most_pieces = 1 << 20;
  std::vector<glm::dvec2> points(line.begin(), line.begin() + !line.empty());
  for (std::size_t i = 1; i < line.size(); ++i) {
    const int pieces =
        clamped_int(std::ceil(2 * glm::distance(line[i - 1], line[i])), 1, most_pieces);
    for (int n = 1; n <= pieces; ++n)
      points.push_back(glm::mix(line[i - 1], line[i], double(n) / pieces));
  }
  return points;
}

}  // namespace

std::vector<glm::dvec2> points_along(const Cubic<Value>& curve, const Affine& to_pixels) {
  const Cubic<glm::dvec2> c{to_pixels.point(curve.p0.position), to_pixels.vector(curve.m0.position),
                            to_pixels.vector(curve.m1.position),
                            to_pixels.point(curve.p1.position)};
  const glm::dvec2 chord = c.p1 - c.p0;
  const double bend = (glm::length(c.m0 - chord) + glm::length(c.m1 - chord)) / 3;
  const double length = glm::length(chord) + bend;
  constexpr double straight = 0.2, longest_piece = 6;
  constexpr int most_pieces = 64;
  const int pieces =
      bend < straight ? 1 : clamped_int(std::ceil(length / longest_piece), 4, most_pieces);
  std::vector<glm::dvec2> points;
  for (int i = 0; i <= pieces; ++i) points.push_back(c.at(double(i) / pieces));
  return points;
}

std::optional<Pointed> pointed_at(const Mesh& mesh, const Affine& to_pixels, glm::dvec2 place,
                                  double reach) {
  constexpr double just_outside = 1.5;
  std::optional<Pointed> found;
  double least = std::max(just_outside, reach);
  for (const Face face : mesh.faces()) {
    const Patch patch = mesh.patch(face);
    if (distance_to_box(patch, to_pixels, place) > std::max(least, 0.1)) continue;
    const Closest c = closest_in(patch, to_pixels, place);
    // Of patches that lie over each other the last is on top.
    if (c.distance > std::max(least, 0.1)) continue;
    least = std::min(least, c.distance);
    found = Pointed{face, c.along_top, c.along_left, {}};
  }
  if (!found) return std::nullopt;
  Nearest<Halfedge> side(reach), edge(reach), corner(reach);
  for (const Halfedge each : mesh.sides(found->face)) {
    const double d = distance_to_curve(place, points_along(mesh.side_of(each), to_pixels));
    side.take(each, d);
    if (mesh.other_side(each).valid()) edge.take(each, d);
    const glm::dvec2 start = to_pixels.point(mesh.position(mesh.origin(each)));
    corner.take(each, glm::distance(start, place));
  }
  found->side = side.found;
  found->edge = edge.found;
  found->corner = corner.found;
  return found;
}

std::optional<Grip> grip_at(const Mesh& mesh, const Affine& to_pixels, glm::dvec2 place,
                            double reach) {
  const auto distance = [&](glm::dvec2 p) { return glm::distance(to_pixels.point(p), place); };
  Nearest<Point> point(reach);
  for (const Point each : mesh.points())
    if (!mesh[each].is_junction()) point.take(each, distance(mesh.position(each)));
  Nearest<Halfedge> start(point.found.valid() ? std::nextafter(point.distance, 0.0) : reach);
  Nearest<Halfedge> end = start;
  for (const Halfedge curve : mesh.curves()) {
    const Cubic<Value> c = mesh.curve_of(curve);
    start.take(curve, distance(c.bezier1().position));
    end.take(curve, distance(c.bezier2().position));
  }
  if (end.found.valid() && end.distance < start.distance) return Grip{{}, end.found, true};
  if (start.found.valid()) return Grip{{}, start.found, false};
  if (point.found.valid()) return Grip{point.found, {}, false};
  return std::nullopt;
}

std::vector<Face> faces_covered(const Mesh& mesh, const Affine& to_pixels,
                                const std::vector<glm::dvec2>& lasso) {
  constexpr double enough = 1.0 / 3;
  const FilledOutline area{{lasso}, FillRule::nonzero};
  std::vector<Face> covered;
  Face best;
  double most = 0;
  for (const Face face : mesh.faces()) {
    const double share = share_inside(mesh.patch(face), to_pixels, area);
    if (share >= enough) covered.push_back(face);
    if (share > most) {
      most = share;
      best = face;
    }
  }
  if (covered.empty() && best.valid()) covered.push_back(best);
  return covered;
}

std::vector<Face> faces_touched(const Mesh& mesh, const Affine& to_pixels,
                                const std::vector<glm::dvec2>& line) {
  const std::vector<glm::dvec2> points = pixels_along(line);
  std::vector<Face> touched;
  for (const Face face : mesh.faces()) {
    FilledOutline outline = face_outline(mesh, face);
    outline.outline = mapped(outline.outline, to_pixels);
    Box box;
    for (const glm::dvec2 p : outline.outline.front()) box.add(p);
    const bool is_touched = std::ranges::any_of(points, [&](glm::dvec2 p) {
      return p.x >= box.low().x && p.y >= box.low().y && p.x <= box.high().x &&
             p.y <= box.high().y && contains(outline, p);
    });
    if (is_touched) touched.push_back(face);
  }
  return touched;
}

}  // namespace gradmesh
