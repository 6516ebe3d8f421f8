#include "ops/merge/split_share.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

namespace gradmesh {
namespace {

/// Sums of s^n, by n, over the points s = i / 8 at which curves are compared.
using PowerSums = std::array<double, 7>;

constexpr PowerSums power_sums(int first, int last) {
  PowerSums sums{};
  for (int i = first; i <= last; ++i) {
    double power = 1;
    for (double& sum : sums) {
      sum += power;
      power *= i / 8.0;
    }
  }
  return sums;
}

/// The point where the two curves meet counts once.
constexpr PowerSums in_sums = power_sums(1, 8), out_sums = power_sums(0, 7);

/// Measures how far the curve that two curves become deviates from them.
class Deviation {
 public:
  Deviation(const Mesh& mesh, const MergeEnd& end) : mesh_(mesh), end_(end) {
    const Cubic<Value> in = mesh.curve_of(mesh.curve_side(end.in));
    const Cubic<Value> out = mesh.curve_of(mesh.curve_side(end.out)).reversed();
    const double scale = length(in) + length(out);
    const double position_weight = scale > 0 ? 1 / scale : 0;
    in_ = half(in, out, position_weight);
    out_ = half(out, in, position_weight);
  }

  /// Returns the sum of squared deviations at a few points, if `end.in` gets the share r; positions
  /// are shares of the curve's length. Colour counts little: colour that is a little too far along
  /// the curve is hardly seen, while a wrong outline is.
  double at(double r) const {
    const double t = combined_share(mesh_, end_, r);
    return strays(in_, t, in_sums) + strays(out_, 1 - t, out_sums);
  }

 private:
  using Vector = std::array<double, 6>;

  /// One of the two curves, from its outer end: the vectors of the polynomial by which the combined
  /// curve deviates from it.
  struct Half {
    /// From this outer end to that of the other curve; tangents at both, in this direction.
    Vector chord, tangent, far_tangent;
    /// The curve itself: outer end to the point where both meet, coefficients of s^2 and s^3.
    Vector to_joint, square, cube;
  };

  static Half half(const Cubic<Value>& curve, const Cubic<Value>& other, double position_weight) {
    constexpr double color_weight = 0.31622776601683794;  // counts as 0.1 when squared
    const auto weighted = [&](const Value& v) {
      const glm::dvec2 p = v.position * position_weight;
      const glm::dvec4 c = v.color * color_weight;
      return Vector{p.x, p.y, c.r, c.g, c.b, c.a};
    };
    const Value to_joint = curve.p1 - curve.p0;
    return {weighted(other.p0 - curve.p0),
            weighted(curve.m0),
            weighted(-other.m0),
            weighted(to_joint),
            weighted(3.0 * to_joint - 2.0 * curve.m0 - curve.m1),
            weighted(curve.m0 + curve.m1 - 2.0 * to_joint)};
  }

  /// Returns the sum of squares for one half: of the combined curve over [0, t], its outer tangents
  /// divided by t and 1 - t (Eq. 5), less the half that it replaces, both with s from 0 to 1. Value
  /// and slope agree at s = 0, so a s^2 + b s^3 is left.
  double strays(const Half& half, double t, const PowerSums& sums) const {
    const bool is_linear = mesh_.color_model() == ColorModel::bilinear;
    const std::size_t cubics = is_linear ? 2 : 6;
    const double t2 = t * t, t3 = t2 * t, over_rest = 1 / (1 - t);
    double aa = 0, ab = 0, bb = 0, linear = 0;
    for (std::size_t k = 0; k < cubics; ++k) {
      const double far = half.far_tangent[k] * over_rest;
      const double a = t2 * (3 * half.chord[k] - far) - 2 * t * half.tangent[k] - half.square[k];
      const double b = t3 * (far - 2 * half.chord[k]) + t2 * half.tangent[k] - half.cube[k];
      aa += a * a;
      ab += a * b;
      bb += b * b;
    }
    for (std::size_t k = cubics; k < 6; ++k) {
      const double c = t * half.chord[k] - half.to_joint[k];
      linear += c * c;
    }
    return sums[4] * aa + 2 * sums[5] * ab + sums[6] * bb + sums[2] * linear;
  }

  const Mesh& mesh_;
  const MergeEnd& end_;
  Half in_, out_;
};

/// A share that was tried, and its deviation.
struct Trial {
  double r, deviation;
};

/// Returns the distance from the first trial to the lowest point of the parabola through three; not
/// finite where there is none.
double step_to_vertex(const Trial& a, const Trial& b, const Trial& c) {
  const double ab = (b.r - a.r) * (a.deviation - c.deviation);
  const double ac = (c.r - a.r) * (a.deviation - b.deviation);
  return 0.5 * ((c.r - a.r) * ac - (b.r - a.r) * ab) / (ac - ab);
}

/// Returns the share of the least deviation near r, by Brent's method: golden sections at first,
/// then, unless that leads nowhere, the lowest point of the parabola through the three best trials.
double refined(const Deviation& deviation, double r) {
  constexpr double around = 0.15, golden = 0.3819660112501051, precision = 1e-7;
  double low = std::max(smallest_share, r - around);
  double high = std::min(1 - smallest_share, r + around);
  const double first = low + golden * (high - low);
  Trial best{first, deviation.at(first)}, second = best, third = best;
  double step = 0, step_before = 0;
  // This number of sections finds the valley in which the least lies, should there be several.
  constexpr int sections = 6, most = 30;
  for (int i = 0; i < most && std::max(best.r - low, high - best.r) > 2 * precision; ++i) {
    const double room = best.r < 0.5 * (low + high) ? high - best.r : low - best.r;
    double next = step_to_vertex(best, second, third);
    const bool converges = i >= sections && std::abs(next) < 0.5 * std::abs(step_before);
    if (converges && best.r + next > low && best.r + next < high) {
      step_before = step;
    } else {
      step_before = room;
      next = golden * room;
    }
    // Steps below the precision would measure nothing but roundings.
    step = std::abs(next) >= precision ? next : std::copysign(precision, room);
    const Trial trial{best.r + step, deviation.at(best.r + step)};
    if (trial.deviation <= best.deviation) {
      (trial.r < best.r ? high : low) = best.r;
      third = second;
      second = best;
      best = trial;
    } else {
      (trial.r < best.r ? low : high) = trial.r;
      if (trial.deviation <= second.deviation || second.r == best.r) {
        third = second;
        second = trial;
      } else if (trial.deviation <= third.deviation || third.r == best.r || third.r == second.r) {
        third = trial;
      }
    }
  }
  return best.r;
}

}  // namespace

double length(const Cubic<Value>& curve) {
  constexpr std::size_t steps = 16;
  const Cubic<glm::dvec2> line{curve.p0.position, curve.m0.position, curve.m1.position,
                               curve.p1.position};
  std::array<glm::dvec2, steps + 1> points;
  for (std::size_t i = 0; i <= steps; ++i) points[i] = line.at(double(i) / steps);
  std::array<double, steps> lengths;
  for (std::size_t i = 0; i < steps; ++i) lengths[i] = glm::length(points[i + 1] - points[i]);
  return std::accumulate(lengths.begin(), lengths.end(), 0.0);
}

double share_by_length(const Cubic<Value>& in, const Cubic<Value>& out) {
  const double l_in = length(in), l_out = length(out);
  return l_in + l_out > 0 ? l_in / (l_in + l_out) : 0.5;
}

double split_share(const Mesh& mesh, const MergeEnd& end, double r) {
  if (end.kind == MergeEnd::stem) return bar_share(mesh, end);
  const Deviation deviation(mesh, end);
  // Curves that were split exactly deviate by roundings only: Eq. 4 is exact there and stays.
  constexpr double exact = 1e-14;
  const double by_eq4 = deviation.at(r);
  if (by_eq4 < exact) return r;
  const double by_length = std::clamp(share_by_length(mesh.side_of(end.in), mesh.side_of(end.out)),
                                      smallest_share, 1 - smallest_share);
  return refined(deviation, deviation.at(by_length) < by_eq4 ? by_length : r);
}

}  // namespace gradmesh
