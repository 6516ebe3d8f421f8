#include "form/written_patch.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "form/handles.h"
#include "form/rounding.h"

namespace gradmesh {
namespace {

double round_to_8_bits(double channel) {
  return std::round(std::clamp(channel, 0.0, 1.0) * 255) / 255;
}

/// The largest differences of channels from grey, in levels: enough to reach every opacity.
constexpr int most_red = 3, most_green = 1, most_blue = 5;

double distance_from_coons(const BezierNet& net) {
  const auto coons = coons_interior(net);
  double most = 0;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      most = std::max(most, glm::length(net[1 + a][1 + b].position - coons[a][b]));
  return most;
}

/// Returns the patch with all coordinates rounded to the step, straight sides as lines.
Patch rounded(const Patch& patch, const Precision& precision, const PatchTolerance& tolerance) {
  const Affine& to_written = precision.to_written;
  const auto round = [&](glm::dvec2 p) { return round_to_step(p, precision.step); };
  std::array<Cubic<Value>, 4> sides;
  for (int k = 0; k < 4; ++k) {
    const Cubic<Value> side = patch.side(k);
    const glm::dvec2 from = round(to_written.point(side.p0.position));
    const glm::dvec2 to = round(to_written.point(side.p1.position));
    Cubic<Value>& written = sides[std::size_t(k)] = side;
    written.p0.position = from;
    written.p1.position = to;
    written.m0.position = written.m1.position = to - from;
    if (is_straight(side, tolerance.straight[std::size_t(k)])) continue;
    written.m0.position = 3.0 * (round(to_written.point(side.bezier1().position)) - from);
    written.m1.position = 3.0 * (to - round(to_written.point(side.bezier2().position)));
  }
  Patch result = patch_from_sides(sides, {});
  make_coons(result);
  if (needs_tensor(patch, tolerance.coons)) {
    Patch placed = patch;
    transform(placed, to_written);
    const BezierNet wanted = bezier_net(placed);
    BezierNet net = bezier_net(result);
    for (const int i : {1, 2})
      for (const int j : {1, 2}) {
        const int corner_i = i == 1 ? 0 : 3, corner_j = j == 1 ? 0 : 3;
        net[i][j].position = net[corner_i][corner_j].position +
                             round(wanted[i][j].position - wanted[corner_i][corner_j].position);
      }
    result = patch_from_bezier(net);
  }
  transform(result, to_written.inverse());
  make_color_bilinear(result);
  return result;
}

}  // namespace

bool needs_tensor(const Patch& patch, double tolerance) {
  return distance_from_coons(bezier_net(patch)) > tolerance;
}

glm::dvec3 mask_color(double opacity) {
  const double level = 255 * std::clamp(opacity, 0.0, 1.0);
  const double grey = std::round(level);
  glm::dvec3 best(grey);
  double least = std::abs(level - grey);
  int off_grey = 0;
  for (int r = -most_red; r <= most_red; ++r)
    for (int g = -most_green; g <= most_green; ++g)
      for (int b = -most_blue; b <= most_blue; ++b) {
        const glm::dvec3 color = grey + glm::dvec3(r, g, b);
        if (color != glm::clamp(color, 0.0, 255.0)) continue;
        // Sums that differ by less are equal up to rounding.
        constexpr double same = 1e-9;
        const double distance = std::abs(level - mask_opacity(color));
        const int off = std::abs(r) + std::abs(g) + std::abs(b);
        if (distance > least + same || (distance > least - same && off >= off_grey)) continue;
        best = color;
        least = distance;
        off_grey = off;
      }
  return best / 255.0;
}

double mask_opacity(const glm::dvec3& color) {
  // For a grey this is its level to the last bit.
  return color.r + 0.7154 * (color.g - color.r) + 0.0721 * (color.b - color.r);
}

Patch as_written(const Patch& patch, double tolerance, bool masked_opacity) {
  Patch written = patch;
  if (!needs_tensor(patch, tolerance)) make_coons(written);
  for (int i : {0, 3})
    for (int j : {0, 3}) {
      glm::dvec4& color = written.c[i][j].color;
      color = {round_to_8_bits(color.r), round_to_8_bits(color.g), round_to_8_bits(color.b),
               masked_opacity ? mask_opacity(mask_color(color.a)) : std::clamp(color.a, 0.0, 1.0)};
    }
  make_color_bilinear(written);
  return written;
}

double straight_tolerance(double coons_tolerance) {
  constexpr double share = 0.1;
  return share * coons_tolerance;
}

Precision precision_for(double coons_tolerance, double share, const Affine& to_written) {
  const glm::dmat2 back = to_written.inverse().linear;
  const double most = 2 * share * coons_tolerance;
  return {coons_tolerance, to_written,
          decimal_step(most / std::hypot(glm::length(back[0]), glm::length(back[1]))), 0};
}

PatchTolerance patch_tolerance(const Precision& precision) {
  PatchTolerance tolerance{precision.coons_tolerance};
  tolerance.straight.fill(straight_tolerance(precision.coons_tolerance));
  return tolerance;
}

Patch written_patch(const Patch& patch, const Precision& precision, const PatchTolerance& tolerance,
                    bool masked_opacity) {
  const Patch written = as_written(patch, tolerance.coons, masked_opacity);
  return precision.step > 0 ? rounded(written, precision, tolerance) : written;
}

}  // namespace gradmesh
