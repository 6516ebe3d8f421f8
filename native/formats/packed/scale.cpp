#include "formats/packed/scale.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "base/power_of_ten.h"
#include "form/handles.h"
#include "form/written_patch.h"
#include "geom/box.h"

namespace gradmesh {
namespace {

/// What reading and transforming a mesh leaves of roundings, as a share of how far it reaches.
constexpr double rounding_share = 1e-11;

double largest(double low, double high) { return std::max(std::abs(low), std::abs(high)); }

/// Returns the points of all patches that are not the thirds of lines or inside Coons patches.
std::vector<glm::dvec2> free_points(const std::vector<PatchGrid>& grids, double rounding) {
  std::vector<glm::dvec2> points;
  for (const PatchGrid& grid : grids)
    for (const Patch& patch : grid.patches) {
      const BezierNet net = bezier_net(patch);
      for (int k = 0; k < 4; ++k) {
        const Cubic<Value> side = patch.side(k);
        points.push_back(side.p0.position);
        if (is_straight(side, rounding)) continue;
        points.push_back(side.bezier1().position);
        points.push_back(side.bezier2().position);
      }
      if (!needs_tensor(patch, rounding)) continue;
      for (const std::size_t i : {1, 2})
        for (const std::size_t j : {1, 2}) points.push_back(net[i][j].position);
    }
  return points;
}

/// Returns the power of two that is at most 2^-precision of the size.
AxisStep binary_step(double low, double high, int precision) {
  constexpr int most_bits = 50;  // Of a double, so that steps are counted exactly.
  const double size = high - low;
  if (largest(low, high) == 0) return {};
  const int finest = std::ilogb(largest(low, high)) - most_bits;
  return {false, std::max({size > 0 ? std::ilogb(size) - precision : finest, finest, -1000})};
}

/// Returns the largest decimal step that is at least `least` and of which all are multiples;
/// `least` if there is none.
AxisStep decimal_step(const std::vector<double>& numbers, double reach, const AxisStep& least) {
  constexpr int most_decimals = 15;
  const double rounding = rounding_share * reach;
  // Of finer steps everything is a multiple but for rounding.
  const double finest = std::max(least.times(1), 100 * rounding);
  for (AxisStep step{true, 0}; step.exponent >= -most_decimals && step.times(1) >= finest;
       --step.exponent)
    if (std::ranges::all_of(numbers, [&](double x) {
          return std::abs(x - step.times(std::round(step.count(x)))) <= rounding;
        }))
      return step;
  return least;
}

std::int64_t levels_of(const std::vector<PatchGrid>& grids, int channel) {
  constexpr double rounding = 1e-6;
  const auto are_all = [&](std::int64_t levels) {
    for (const PatchGrid& grid : grids)
      for (const Patch& patch : grid.patches)
        for (int k = 0; k < 4; ++k) {
          const double level =
              double(levels) * std::clamp(patch.corner(k).color[channel], 0.0, 1.0);
          if (std::abs(level - std::round(level)) > rounding) return false;
        }
    return true;
  };
  return are_all(255) ? 255 : are_all(1000) ? 1000 : 65535;
}

}  // namespace

double AxisStep::times(double steps) const {
  if (!is_decimal) return std::ldexp(steps, exponent);
  return exponent < 0 ? steps / power_of_ten(-exponent) : steps * power_of_ten(exponent);
}

double AxisStep::count(double number) const {
  if (!is_decimal) return std::ldexp(number, -exponent);
  return exponent < 0 ? number * power_of_ten(-exponent) : number / power_of_ten(exponent);
}

double AxisStep::noise() const {
  // Thirds of a decimal step may be meant, and 27ths inside a Coons patch.
  constexpr double decimal = 0.02, rounded = 0.75;
  return is_decimal ? decimal : rounded;
}

Scale scale_for(const std::vector<PatchGrid>& grids, int precision) {
  Box box;
  for (const PatchGrid& grid : grids)
    for (const Patch& patch : grid.patches)
      for (const auto& row : bezier_net(patch))
        for (const Value& value : row) box.add(value.position);
  const glm::dvec2 reach = glm::max(glm::abs(box.low()), glm::abs(box.high()));
  const std::vector<glm::dvec2> points =
      free_points(grids, rounding_share * std::max(reach.x, reach.y));
  Scale scale;
  for (int axis = 0; axis < 2; ++axis) {
    std::vector<double> numbers;
    for (const glm::dvec2 p : points) numbers.push_back(p[axis]);
    const AxisStep binary = binary_step(box.low()[axis], box.high()[axis], precision);
    scale.steps[std::size_t(axis)] = decimal_step(numbers, reach[axis], binary);
  }
  for (int channel = 0; channel < 4; ++channel)
    scale.levels[std::size_t(channel)] = levels_of(grids, channel);
  return scale;
}

bool lie_near(const std::vector<PatchGrid>& grids) {
  constexpr double farthest = 1e9;
  for (const PatchGrid& grid : grids)
    for (const Patch& patch : grid.patches)
      for (const auto& row : bezier_net(patch))
        for (const Value& value : row)
          if (!(std::abs(value.position.x) <= farthest && std::abs(value.position.y) <= farthest))
            return false;
  return true;
}

}  // namespace gradmesh
