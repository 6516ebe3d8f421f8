#include "reference/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "raster/hidden.h"

namespace gradmesh {
namespace {

/// Colours of neighbouring pixels that differ by more than this belong to two surfaces, 0..1.
constexpr double edge_in_picture = 0.06;

/// Returns the numbers from 0 to 1 that the levels of 8 bits stand for; divisions take long.
constexpr std::array<double, 256> shares_of_levels() {
  std::array<double, 256> shares{};
  for (std::size_t level = 0; level < shares.size(); ++level) shares[level] = double(level) / 255.0;
  return shares;
}

glm::dvec3 color_of(const Image& image, int x, int y) {
  static constexpr std::array<double, 256> share = shares_of_levels();
  const auto pixel = image.pixel(x, y);
  return {share[pixel[0]], share[pixel[1]], share[pixel[2]]};
}

}  // namespace

Reference::Reference(const Mesh& original, const Frame& frame, MetricKind metric)
    : frame_(frame),
      painting_(paint_whole(original, frame)),
      metric_kind_(metric),
      outlines_(original, frame) {}

const Metric& Reference::metric() const {
  std::call_once(metric_is_made_, [&] { metric_ = make_metric(metric_kind_, painting_.image); });
  return *metric_;
}

std::optional<glm::dvec3> Reference::color_at(glm::dvec2 place) const {
  const double x = place.x - 0.5, y = place.y - 0.5;
  const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
  if (x0 < 0 || y0 < 0 || x0 + 1 >= frame_.width || y0 + 1 >= frame_.height) return {};
  const double fx = x - x0, fy = y - y0;
  const int nearest_x = x0 + (fx > 0.5), nearest_y = y0 + (fy > 0.5);
  if (*painting_.top.at(nearest_x, nearest_y) == 0) return {};
  const glm::dvec3 nearest = color_of(painting_.image, nearest_x, nearest_y);
  glm::dvec3 sum(0.0), low = nearest, high = nearest;
  for (const int dy : {0, 1})
    for (const int dx : {0, 1}) {
      const bool is_covered = *painting_.top.at(x0 + dx, y0 + dy) != 0;
      const glm::dvec3 color = is_covered ? color_of(painting_.image, x0 + dx, y0 + dy) : nearest;
      sum += (dx ? fx : 1 - fx) * (dy ? fy : 1 - fy) * color;
      low = glm::min(low, color);
      high = glm::max(high, color);
    }
  const glm::dvec3 range = high - low;
  return std::max({range.r, range.g, range.b}) > edge_in_picture ? nearest : sum;
}

bool Reference::is_hidden(glm::dvec2 place) const {
  return frame_.hidden &&
         frame_.hidden->contains(int(std::floor(place.x)), int(std::floor(place.y)));
}

}  // namespace gradmesh
