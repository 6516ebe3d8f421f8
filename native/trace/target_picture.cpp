#include "trace/target_picture.h"

#include <algorithm>
#include <glm/vec3.hpp>
#include <numeric>

namespace gradmesh {
namespace {

/// How far beyond the middle of a pixel cairo samples in the mean: its steps are 0.35 to 0.7 pixels
/// long, and the last one within the pixel counts.
constexpr double cairo_is_beyond = 0.24;

/// Returns the point within a pixel that is `factor` times as long as before.
double point_of_larger(double point, double factor) {
  return 0.5 + std::min(0.49, (point - 0.5) / factor);
}

}  // namespace

double TargetPicture::counted() const {
  if (weights.empty()) return double(samples());
  return std::accumulate(weights.begin(), weights.end(), 0.0);
}

double point_of_pixels(double scale) {
  return point_of_larger(0.5 + cairo_is_beyond, std::max(1.0, scale));
}

glm::vec4 level_for(const std::array<std::uint8_t, 4>& pixel) {
  const auto mixed = [](std::uint8_t level) { return (float(level) + 0.5f) * (256.0f / 257.0f); };
  return {mixed(pixel[0]), mixed(pixel[1]), mixed(pixel[2]), pixel[3]};
}

TargetPicture target_of(const RgbaImage& picture, double scale) {
  TargetPicture target;
  target.width = picture.width;
  target.height = picture.height;
  target.point = point_of_pixels(scale);
  target.pixels.reserve(picture.pixels());
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      target.pixels.push_back(level_for(picture.pixel(x, y)));
      target.is_opaque = target.is_opaque && target.pixels.back().a == 255;
    }
  return target;
}

TargetPicture halved(const TargetPicture& target) {
  TargetPicture half;
  half.width = (target.width + 1) / 2;
  half.height = (target.height + 1) / 2;
  half.is_opaque = target.is_opaque;
  half.point = point_of_larger(target.point, 2);
  half.pixels.reserve(std::size_t(half.width) * std::size_t(half.height));
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x) {
      glm::vec3 color(0.0f), plain(0.0f);
      float opacity = 0, counted = 0;
      for (const int dy : {0, 1})
        for (const int dx : {0, 1}) {
          const int from_x = std::min(2 * x + dx, target.width - 1);
          const int from_y = std::min(2 * y + dy, target.height - 1);
          const glm::vec4& pixel = target.at(from_x, from_y);
          const auto weight = float(target.weight(from_x, from_y));
          color += weight * pixel.a * glm::vec3(pixel);
          plain += glm::vec3(pixel);
          opacity += weight * pixel.a;
          counted += weight;
        }
      half.pixels.emplace_back(opacity > 0 ? color / opacity : plain / 4.0f,
                               counted > 0 ? opacity / counted : 255.0f);
      if (!target.weights.empty()) half.weights.push_back(counted / 4);
    }
  return half;
}

}  // namespace gradmesh
