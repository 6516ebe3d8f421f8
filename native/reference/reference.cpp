#include "reference/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "base/clamped_int.h"
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

/// The bit of a texel that says that the original covers the pixel; below it are the levels.
constexpr std::uint32_t is_covered = 1u << 24;

/// Returns for each pixel what a sample of the picture reads of it.
Raster<std::uint32_t, 1> texels_of(const Painting& painting) {
  Raster<std::uint32_t, 1> texels(painting.window());
  for (int y = texels.y0; y < texels.y0 + texels.height; ++y)
    for (int x = texels.x0; x < texels.x0 + texels.width; ++x) {
      const auto [r, g, b] = painting.image.pixel(x, y);
      const std::uint32_t covered = *painting.top.at(x, y) != 0 ? is_covered : 0;
      *texels.at(x, y) = covered | std::uint32_t(r) << 16 | std::uint32_t(g) << 8 | b;
    }
  return texels;
}

glm::dvec3 color_of(std::uint32_t texel) {
  static constexpr std::array<double, 256> share = shares_of_levels();
  return {share[texel >> 16 & 255], share[texel >> 8 & 255], share[texel & 255]};
}

Raster<std::uint8_t, 1> away_from_outline_of(const Raster<std::uint32_t, 1>& top) {
  constexpr int width = 3;
  Raster<std::uint8_t, 1> result(top.window(), 1);
  for (int y = 0; y < top.height; ++y)
    for (int x = 0; x < top.width; ++x) {
      if (*top.at(x, y) != 0) continue;
      const bool is_beside = (x > 0 && *top.at(x - 1, y)) || (y > 0 && *top.at(x, y - 1)) ||
                             (x + 1 < top.width && *top.at(x + 1, y)) ||
                             (y + 1 < top.height && *top.at(x, y + 1));
      if (is_beside)
        fill(result, Window{x, y, x + 1, y + 1}.grown(width).clipped(top.window()),
             std::uint8_t(0));
    }
  return result;
}

}  // namespace

Frame on_black(Frame frame) {
  frame.ground = 0;
  return frame;
}

Reference::Reference(const Original& original, const Frame& frame, MetricKind metric)
    : frame_(frame),
      painting_(original.painted(frame)),
      on_black_(original.is_translucent() ? original.painted(on_black(frame)).image : Image()),
      texels_(texels_of(painting_)),
      away_from_outline_(away_from_outline_of(painting_.top)),
      metric_kind_(metric),
      outlines_(original.outlines(frame)) {}

// Nothing keeps the original, so that the mesh need not be shared.
Reference::Reference(const Mesh& original, const Frame& frame, MetricKind metric)
    : Reference(*original_of(std::shared_ptr<const Mesh>(std::shared_ptr<const Mesh>(), &original)),
                frame, metric) {}

const Metric& Reference::metric() const {
  std::call_once(metric_is_made_,
                 [&] { metric_ = make_metric(metric_kind_, painting_.image, frame_.weights); });
  return *metric_;
}

const Metric* Reference::metric_on_black() const {
  if (on_black_.samples.empty()) return nullptr;
  std::call_once(metric_on_black_is_made_,
                 [&] { metric_on_black_ = make_metric(metric_kind_, on_black_, frame_.weights); });
  return metric_on_black_.get();
}

std::optional<glm::dvec3> Reference::color_at(glm::dvec2 place) const {
  const double x = place.x - 0.5, y = place.y - 0.5;
  const int x0 = clamped_pixel(std::floor(x)), y0 = clamped_pixel(std::floor(y));
  if (x0 < 0 || y0 < 0 || x0 + 1 >= frame_.width || y0 + 1 >= frame_.height) return {};
  const double fx = x - x0, fy = y - y0;
  const std::uint32_t* const rows[] = {texels_.at(x0, y0), texels_.at(x0, y0 + 1)};
  const std::uint32_t closest = rows[fy > 0.5][fx > 0.5];
  if (!(closest & is_covered)) return {};
  const glm::dvec3 nearest = color_of(closest);
  glm::dvec3 sum(0.0), low = nearest, high = nearest;
  for (const int dy : {0, 1})
    for (const int dx : {0, 1}) {
      const std::uint32_t texel = rows[dy][dx];
      const glm::dvec3 color = texel & is_covered ? color_of(texel) : nearest;
      sum += (dx ? fx : 1 - fx) * (dy ? fy : 1 - fy) * color;
      low = glm::min(low, color);
      high = glm::max(high, color);
    }
  const glm::dvec3 range = high - low;
  return std::max({range.r, range.g, range.b}) > edge_in_picture ? nearest : sum;
}

bool Reference::is_hidden(glm::dvec2 place) const {
  return frame_.hidden && frame_.hidden->contains(clamped_pixel(std::floor(place.x)),
                                                  clamped_pixel(std::floor(place.y)));
}

}  // namespace gradmesh
