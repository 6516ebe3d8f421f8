#include "trace/guide.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "geom/cross.h"

namespace gradmesh {
namespace {

/// How far along each of two segments, 0..1, they cross.
std::optional<glm::dvec2> shares_at_crossing(glm::dvec2 a, glm::dvec2 along_a, glm::dvec2 b,
                                             glm::dvec2 along_b) {
  const double size = cross(along_a, along_b);
  if (size == 0) return {};
  const glm::dvec2 shares(cross(b - a, along_b) / size, cross(b - a, along_a) / size);
  const bool is_on_both = shares.x >= 0 && shares.x <= 1 && shares.y >= 0 && shares.y <= 1;
  return is_on_both ? std::optional(shares) : std::nullopt;
}

}  // namespace

Guide::Guide(const std::vector<glm::dvec2>& line) : points_{line.front()}, ends_{0} {
  for (const glm::dvec2 point : line) {
    const double step = glm::distance(points_.back(), point);
    if (!(step > 0)) continue;
    ends_.push_back(ends_.back() + step);
    points_.push_back(point);
  }
}

glm::dvec2 Guide::at(double way) const {
  const auto end = std::ranges::upper_bound(ends_, way);
  if (end == ends_.begin()) return points_.front();
  if (end == ends_.end()) return points_.back();
  const auto k = std::size_t(end - ends_.begin());
  const double share = (way - ends_[k - 1]) / (ends_[k] - ends_[k - 1]);
  return points_[k - 1] + share * (points_[k] - points_[k - 1]);
}

glm::dvec2 Guide::direction(double way) const {
  const double reach = std::min(1.0, length() / 4);
  const double middle = std::clamp(way, reach, length() - reach);
  const glm::dvec2 along = at(middle + reach) - at(middle - reach);
  const double size = glm::length(along);
  return size > 0 ? along / size : glm::dvec2(1, 0);
}

double Guide::nearest(glm::dvec2 place) const {
  double least = std::numeric_limits<double>::infinity(), way = 0;
  for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
    const glm::dvec2 along = points_[k + 1] - points_[k];
    const double share =
        std::clamp(glm::dot(place - points_[k], along) / glm::dot(along, along), 0.0, 1.0);
    const double distance = glm::distance(place, points_[k] + share * along);
    if (distance >= least) continue;
    least = distance;
    way = ends_[k] + share * (ends_[k + 1] - ends_[k]);
  }
  return way;
}

Guide Guide::piece(double from, double to) const {
  const auto [low, high] = std::minmax(from, to);
  std::vector<glm::dvec2> points{at(low)};
  for (std::size_t k = 0; k < points_.size(); ++k)
    if (ends_[k] > low && ends_[k] < high) points.push_back(points_[k]);
  points.push_back(at(high));
  if (to < from) std::ranges::reverse(points);
  return Guide(points);
}

std::optional<std::pair<double, double>> Guide::crossing(const Guide& other,
                                                         glm::dvec2 near) const {
  std::optional<std::pair<double, double>> ways;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < points_.size(); ++k)
    for (std::size_t n = 0; n + 1 < other.points_.size(); ++n) {
      const glm::dvec2 here = points_[k + 1] - points_[k];
      const auto shares = shares_at_crossing(points_[k], here, other.points_[n],
                                             other.points_[n + 1] - other.points_[n]);
      if (!shares) continue;
      const double distance = glm::distance(near, points_[k] + shares->x * here);
      if (distance >= least) continue;
      least = distance;
      ways = std::pair(ends_[k] + shares->x * (ends_[k + 1] - ends_[k]),
                       other.ends_[n] + shares->y * (other.ends_[n + 1] - other.ends_[n]));
    }
  return ways;
}

}  // namespace gradmesh
