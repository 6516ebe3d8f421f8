#include "ops/split_share.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace gradmesh {
namespace {

/// How far the curve that two curves become strays from them.
class Deviation {
 public:
  Deviation(const Mesh& mesh, const MergeEnd& end)
      : mesh_(mesh),
        end_(end),
        in_(mesh.curve_of(mesh.curve_side(end.in))),
        out_(mesh.curve_of(mesh.curve_side(end.out))),
        scale_(length(in_) + length(out_)) {}

  /// Sum of squares at a few points, if `end.in` gets the share r; positions as shares of the
  /// curve's length. Colour counts little: a little too far along the curve it is hardly seen,
  /// while a wrong outline is.
  double at(double r) const {
    constexpr int steps = 8;
    constexpr double color_weight = 0.1;
    const double t = combined_share(mesh_, end_, r);
    Cubic<Value> joined{in_.p0, in_.m0 * (1 / t), out_.m1 * (1 / (1 - t)), out_.p1};
    if (mesh_.color_model() == ColorModel::bilinear)
      joined.m0.color = joined.m1.color = joined.p1.color - joined.p0.color;
    double sum = 0;
    for (int i = 1; i <= steps; ++i) {
      const double s = double(i) / steps;
      for (const Value& d :
           {joined.at(t * s) - in_.at(s), joined.at(t + (1 - t) * s) - out_.at(s)}) {
        const double off = scale_ > 0 ? glm::length(d.position) / scale_ : 0;
        sum += off * off + color_weight * glm::dot(d.color, d.color);
      }
    }
    return sum;
  }

 private:
  const Mesh& mesh_;
  const MergeEnd& end_;
  const Cubic<Value> in_, out_;
  const double scale_;
};

/// The least deviation near r, by golden sections.
double refined(const Deviation& deviation, double r) {
  constexpr double around = 0.15, golden = 0.381966;
  double low = std::max(smallest_share, r - around);
  double high = std::min(1 - smallest_share, r + around);
  for (int i = 0; i < 30; ++i) {
    const double a = low + golden * (high - low), b = high - golden * (high - low);
    if (deviation.at(a) < deviation.at(b))
      high = b;
    else
      low = a;
  }
  return 0.5 * (low + high);
}

}  // namespace

double length(const Cubic<Value>& curve) {
  constexpr int steps = 16;
  double sum = 0;
  glm::dvec2 last = curve.p0.position;
  for (int i = 1; i <= steps; ++i) {
    const glm::dvec2 p = curve.at(double(i) / steps).position;
    sum += glm::length(p - last);
    last = p;
  }
  return sum;
}

double share_by_length(const Cubic<Value>& in, const Cubic<Value>& out) {
  const double l_in = length(in), l_out = length(out);
  return l_in + l_out > 0 ? l_in / (l_in + l_out) : 0.5;
}

double split_share(const Mesh& mesh, const MergeEnd& end, double r) {
  if (end.kind == MergeEnd::stem) return bar_share(mesh, end);
  const Deviation deviation(mesh, end);
  // What was split exactly deviates by roundings only: Eq. 4 is exact there and stays.
  constexpr double exact = 1e-14;
  const double by_eq4 = deviation.at(r);
  if (by_eq4 < exact) return r;
  const double by_length = std::clamp(share_by_length(mesh.side_of(end.in), mesh.side_of(end.out)),
                                      smallest_share, 1 - smallest_share);
  return refined(deviation, deviation.at(by_length) < by_eq4 ? by_length : r);
}

}  // namespace gradmesh
