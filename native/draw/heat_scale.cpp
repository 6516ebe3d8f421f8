#include "draw/heat_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>

#include "base/clamped_int.h"

namespace gradmesh {
namespace {

/// Colours at equal distances on the scale; their lightness in Oklab falls from 0.98 to 0.24 by
/// equal steps nearly.
constexpr std::array<std::array<int, 3>, 8> anchors{{{0xfc, 0xf9, 0xe6},
                                                     {0xf7, 0xdd, 0x87},
                                                     {0xfb, 0xb0, 0x35},
                                                     {0xf7, 0x79, 0x1a},
                                                     {0xde, 0x3a, 0x46},
                                                     {0xa7, 0x0e, 0x63},
                                                     {0x5b, 0x11, 0x75},
                                                     {0x1d, 0x12, 0x4b}}};

glm::dvec3 anchor(int i) { return glm::dvec3(anchors[i][0], anchors[i][1], anchors[i][2]) / 255.0; }

}  // namespace

glm::dvec3 heat_color(double t) {
  const double at = std::clamp(t, 0.0, 1.0) * (anchors.size() - 1);
  const int i = clamped_int(at, 0, int(anchors.size()) - 2);
  return glm::mix(anchor(i), anchor(i + 1), at - i);
}

double HeatScale::lowest() const { return highest_ * std::pow(10, -length_); }

double HeatScale::position(double error) const {
  if (error <= lowest()) return 0;
  return std::min(1.0, 1 + std::log10(error / highest_) / length_);
}

double HeatScale::error_at(double position) const {
  return highest_ * std::pow(10, length_ * (position - 1));
}

glm::dvec3 HeatScale::rgb_at(double position) { return heat_color(0.14 + 0.86 * position); }

std::string hex_color(const glm::dvec3& color) {
  const auto byte = [](double c) { return unsigned(std::lround(std::clamp(c, 0.0, 1.0) * 255)); };
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(color.r), byte(color.g), byte(color.b));
  return text;
}

}  // namespace gradmesh
