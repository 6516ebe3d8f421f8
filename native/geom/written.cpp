#include "geom/written.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace gradmesh {
namespace {

double round_to_8_bits(double channel) {
  return std::round(std::clamp(channel, 0.0, 1.0) * 255) / 255;
}

double distance_from_coons(const BezierNet& net) {
  const auto coons = coons_interior(net);
  double most = 0;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      most = std::max(most, glm::length(net[1 + a][1 + b].position - coons[a][b]));
  return most;
}

}  // namespace

bool needs_tensor(const Patch& patch, double tolerance) {
  return distance_from_coons(bezier_net(patch)) > tolerance;
}

Patch as_written(const Patch& patch, double tolerance, bool masked_opacity) {
  Patch written = patch;
  if (!needs_tensor(patch, tolerance)) make_coons(written);
  for (int i : {0, 3})
    for (int j : {0, 3}) {
      glm::dvec4& color = written.c[i][j].color;
      color = {round_to_8_bits(color.r), round_to_8_bits(color.g), round_to_8_bits(color.b),
               masked_opacity ? round_to_8_bits(color.a) : std::clamp(color.a, 0.0, 1.0)};
    }
  make_color_bilinear(written);
  return written;
}

}  // namespace gradmesh
