#include "ops/merge/split_share.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numeric>
#include <optional>

namespace gradmesh {

double combined_share(const Mesh& mesh, const MergeEnd& end, double r) {
  const double in_curve = r / mesh.span(end.in).length();
  const double out_curve = (1 - r) / mesh.span(end.out).length();
  return in_curve / (in_curve + out_curve);
}

namespace {

/// The smallest share, and the distance of the largest from 1, which keep 1/r and 1/(1-r) in Eq. 5
/// within reason.
constexpr double smallest_share = 1e-3;

/// Returns the share of `in` in the length of `in` and `out` where both are bars of one parent.
double bar_share(const Mesh& mesh, const MergeEnd& end) {
  const double in = mesh.span(end.in).length(), out = mesh.span(end.out).length();
  return in / (in + out);
}

/// Returns the length of a curve in mesh units, to about a percent.
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

/// Returns the share of `in` in the length of two curves; a half where both have none.
double share_by_length(const Cubic<Value>& in, const Cubic<Value>& out) {
  const double l_in = length(in), l_out = length(out);
  return l_in + l_out > 0 ? l_in / (l_in + l_out) : 0.5;
}

double dot(const Value& a, const Value& b, ColorModel model) {
  // In `bilinear` the colour tangents follow from the corners and say nothing of their own.
  const double color =
      model == ColorModel::bicubic ? glm::dot(glm::dvec3(a.color), glm::dvec3(b.color)) : 0.0;
  return glm::dot(a.position, b.position) + color;
}

/// Returns |m| / |m + n| of Eq. 4, or nothing if m and n do not point the same way or one of them
/// is negligible beside the other.
std::optional<double> share(const Value& m, const Value& n, ColorModel model) {
  const double mm = dot(m, m, model), nn = dot(n, n, model), mn = dot(m, n, model);
  const double smallest = 1e-12 * std::max(mm, nn);
  if (mn <= 0 || mm <= smallest || nn <= smallest) return std::nullopt;
  return std::sqrt(mm / (mm + 2 * mn + nn));
}

/// Returns the mean of the two estimates of Eq. 4 at the tail of `edge`, r1 and r2; seen from the
/// twin these are r4 and r3, as shares of the other patch.
double share_at_tail(const Mesh& mesh, Halfedge edge, const MergeEnd& tail) {
  const Cubic<Value> in = mesh.side_of(tail.in), out = mesh.side_of(tail.out);
  // Tangents across the edge at its inner Bezier point; the local axes of the twist at the start
  // of `edge` are (along the edge, against `in`), hence the sign.
  const Value inner_in = in.m1 - mesh[edge].twist * (1.0 / 3.0);
  const Value inner_out = out.m0 + mesh[tail.out].twist * (1.0 / 3.0);
  const ColorModel model = mesh.color_model();
  const std::optional<double> outer = share(in.m1, out.m0, model);
  const std::optional<double> inner = share(inner_in, inner_out, model);
  const double by_length = outer && inner ? 0.0 : share_by_length(in, out);
  return 0.5 * (outer.value_or(by_length) + inner.value_or(by_length));
}

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

double split_factor(const Mesh& mesh, Halfedge edge, const MergeEnd& tail, const MergeEnd& head) {
  const Halfedge twin = mesh[edge].twin;
  double sum = 0;
  int ends = 0;
  // A stem starts where its parent was split, so only the other end is estimated; between two stems
  // the parents' intervals are all there is to know.
  if (tail.kind != MergeEnd::stem) {
    sum += share_at_tail(mesh, edge, tail);
    ++ends;
  }
  if (head.kind != MergeEnd::stem) {
    sum += 1 - share_at_tail(mesh, twin, head);
    ++ends;
  }
  const double r =
      ends > 0 ? sum / ends : 0.5 * (bar_share(mesh, tail) + 1 - bar_share(mesh, head));
  return std::clamp(r, smallest_share, 1 - smallest_share);
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
