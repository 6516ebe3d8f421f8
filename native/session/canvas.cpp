#include "session/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/clamped_int.h"
#include "session/pointing.h"

namespace gradmesh {
namespace {

/// Returns the pixels that a box touches.
Window pixels_between(glm::dvec2 low, glm::dvec2 high) {
  return {clamped_pixel(std::floor(low.x)), clamped_pixel(std::floor(low.y)),
          clamped_pixel(std::ceil(high.x)), clamped_pixel(std::ceil(high.y))};
}

}  // namespace

void Canvas::lines(const std::vector<std::vector<glm::dvec2>>& lines, const Ink& ink) {
  for (const std::vector<glm::dvec2>& points : lines)
    for (std::size_t i = 1; i < points.size(); ++i)
      segment(points[i - 1], points[i], density_ * ink.width);
  flush(ink);
}

void Canvas::squares(const std::vector<glm::dvec2>& centers, double size, const Ink& ink,
                     const glm::dvec3& edge) {
  for (const bool is_edge : {true, false}) {
    for (const glm::dvec2 center : centers) square(center, density_ * (size / 2 + is_edge));
    flush({is_edge ? edge : ink.color, ink.opacity});
  }
}

/// Covers the pixels of a square, and those at its rim in part.
void Canvas::square(glm::dvec2 center, double half) {
  const glm::dvec2 low = center - half, high = center + half;
  const glm::dvec2 far(image_.width + 1, image_.height + 1);
  if (glm::any(glm::greaterThan(low, far)) || glm::any(glm::lessThan(high, glm::dvec2(-1)))) return;
  const Window window = pixels_between(low, high).clipped(image_.window());
  const auto share = [](int pixel, double from, double to) {
    return std::max(0.0, std::min(pixel + 1.0, to) - std::max(double(pixel), from));
  };
  for (int y = window.y0; y < window.y1; ++y) {
    touched_.push_back({y, window.x0, window.x1});
    for (int x = window.x0; x < window.x1; ++x) {
      float& cover = *cover_.at(x, y);
      cover = std::max(cover, float(share(x, low.x, high.x) * share(y, low.y, high.y)));
    }
  }
}

double Canvas::stripe(int at, double distance, double width) {
  const double across = std::abs(std::remainder(at, distance)) / std::sqrt(2.0);
  return std::clamp(width / 2 + 0.5 - across, 0.0, 1.0);
}

/// Covers the pixels whose centres are within half the width of a segment, and those at the rim in
/// part.
void Canvas::segment(glm::dvec2 a, glm::dvec2 b, double width) {
  const double reach = width / 2 + 0.5;
  const glm::dvec2 low = glm::min(a, b) - reach, high = glm::max(a, b) + reach;
  const glm::dvec2 least(-1), most(image_.width + 1, image_.height + 1);
  if (glm::any(glm::greaterThan(low, most)) || glm::any(glm::lessThan(high, least))) return;
  const glm::dvec2 from = glm::max(low, least), to = glm::min(high, most);
  const Window window = pixels_between(from, to).clipped(image_.window());
  if (window.empty()) return;
  const glm::dvec2 along = b - a;
  const double square = glm::dot(along, along), length = std::sqrt(square);
  // What of a row is within reach of the whole line.
  const double slope = along.x / along.y, aside = reach * std::sqrt(1 + slope * slope);
  const bool is_level = !(std::abs(slope) < 1e6);
  for (int y = window.y0; y < window.y1; ++y) {
    const double middle = a.x + (y + 0.5 - a.y) * slope;
    const int x0 = is_level ? window.x0 : clamped_int(middle - aside - 1, window.x0, window.x1);
    const int x1 = is_level ? window.x1 : clamped_int(middle + aside + 1, window.x0, window.x1);
    touched_.push_back({y, x0, x1});
    float* row = cover_.at(x0, y);
    for (int x = x0; x < x1; ++x, ++row) {
      const glm::dvec2 p(x + 0.5, y + 0.5);
      const glm::dvec2 way = p - a;
      const double t = square > 0 ? glm::dot(way, along) / square : 0;
      // Beside the segment, or beyond one of its ends.
      const double distance = t > 0 && t < 1 ? std::abs(way.x * along.y - way.y * along.x) / length
                                             : glm::length(p - (t < 1 ? a : b));
      const double cover = std::clamp(reach - distance, 0.0, 1.0);
      *row = std::max(*row, float(cover));
    }
  }
}

void Canvas::flush(const Ink& ink) {
  const glm::dvec3 to = 255.0 * ink.color;
  for (const auto [y, x0, x1] : touched_) {
    float* const cover = cover_.at(x0, y);
    const std::array planes{image_.at(x0, y, 0), image_.at(x0, y, 1), image_.at(x0, y, 2)};
    for (int i = 0; i < x1 - x0; ++i) {
      const double share = ink.opacity * cover[i];
      if (share <= 0) continue;
      for (int c = 0; c < 3; ++c) blend(planes[std::size_t(c)][i], to[c], share);
      cover[i] = 0;
    }
  }
  touched_.clear();
}

const Ink below_lines{glm::dvec3(0.0), 0.35, 2.6};

void draw_lines(Canvas& canvas, const Mesh& mesh, const Affine& to_pixels) {
  const Ink light{glm::dvec3(1.0), 0.85, 1.1};
  std::vector<std::vector<glm::dvec2>> lines;
  for (const Halfedge curve : mesh.curves())
    lines.push_back(points_along(mesh.curve_of(curve), to_pixels));
  canvas.lines(lines, below_lines);
  canvas.lines(lines, light);
}

}  // namespace gradmesh
