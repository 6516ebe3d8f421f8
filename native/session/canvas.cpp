#include "session/canvas.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/clamped_int.h"

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
  touched_ = touched_.united(window);
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x) {
      float& cover = *cover_.at(x, y);
      cover = std::max(cover, float(share(x, low.x, high.x) * share(y, low.y, high.y)));
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
  touched_ = touched_.united(window);
  const glm::dvec2 along = b - a;
  const double square = glm::dot(along, along);
  for (int y = window.y0; y < window.y1; ++y) {
    float* row = cover_.at(window.x0, y);
    for (int x = window.x0; x < window.x1; ++x, ++row) {
      const glm::dvec2 p(x + 0.5, y + 0.5);
      const double t = square > 0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0;
      const double cover = std::clamp(reach - glm::length(p - (a + t * along)), 0.0, 1.0);
      *row = std::max(*row, float(cover));
    }
  }
}

void Canvas::blend(int x, int y, const Ink& ink, double cover) {
  const double share = ink.opacity * cover;
  if (share <= 0) return;
  for (int c = 0; c < 3; ++c) {
    std::uint8_t& sample = *image_.at(x, y, c);
    sample = std::uint8_t(std::lround(sample + share * (255 * ink.color[c] - sample)));
  }
}

void Canvas::flush(const Ink& ink) {
  for (int y = touched_.y0; y < touched_.y1; ++y)
    for (int x = touched_.x0; x < touched_.x1; ++x) {
      float& cover = *cover_.at(x, y);
      if (cover > 0) blend(x, y, ink, cover);
      cover = 0;
    }
  touched_ = {};
}

}  // namespace gradmesh
