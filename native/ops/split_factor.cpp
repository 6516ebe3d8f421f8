#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "ops/merge.h"
#include "ops/merge_end.h"

namespace gradmesh {
namespace {

/// Keeps 1/r and 1/(1-r) in Eq. 5 within reason.
constexpr double smallest_share = 1e-3;

double dot(const Value& a, const Value& b, ColorModel model) {
  // In `bilinear` the colour tangents follow from the corners and say nothing of their own.
  const double color =
      model == ColorModel::bicubic ? glm::dot(glm::dvec3(a.color), glm::dvec3(b.color)) : 0.0;
  return glm::dot(a.position, b.position) + color;
}

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

/// |m| / |m + n| of Eq. 4, or `otherwise` where m and n do not point the same way.
double share(const Value& m, const Value& n, double otherwise, ColorModel model) {
  const double mm = dot(m, m, model), nn = dot(n, n, model), mn = dot(m, n, model);
  const double smallest = 1e-12 * std::max(mm, nn);
  if (mn <= 0 || mm <= smallest || nn <= smallest) return otherwise;
  return std::sqrt(mm / (mm + 2 * mn + nn));
}

/// What is known of the split at one end, as shares of `in` in the length of in and out.
struct Estimates {
  /// r1 and r2 of Eq. 4; seen from the twin these are r4 and r3 of the other patch.
  double at_corner, inside;
  double by_length;

  double mean() const { return 0.5 * (at_corner + inside); }
};

Estimates estimates(const Mesh& mesh, Halfedge edge, const MergeEnd& end) {
  const Cubic<Value> in = mesh.side_of(end.in), out = mesh.side_of(end.out);
  const double l_in = length(in), l_out = length(out);
  const double by_length = l_in + l_out > 0 ? l_in / (l_in + l_out) : 0.5;
  // Tangents across the edge at its inner Bezier point; the local axes of the twist at the start
  // of `edge` are (along the edge, against `in`), hence the sign.
  const Value inner_in = in.m1 - mesh[edge].twist * (1.0 / 3.0);
  const Value inner_out = out.m0 + mesh[end.out].twist * (1.0 / 3.0);
  const ColorModel model = mesh.color_model();
  return {share(in.m1, out.m0, by_length, model), share(inner_in, inner_out, by_length, model),
          by_length};
}

/// How far the curve that in and out become strays from them, if `in` gets the share r: the sum of
/// squares at a few points, positions as shares of the curve's length.
double deviation(const Mesh& mesh, const MergeEnd& end, double r) {
  constexpr int steps = 8;
  const Halfedge in_side = mesh.curve_side(end.in), out_side = mesh.curve_side(end.out);
  const Cubic<Value> in = mesh.curve_of(in_side), out = mesh.curve_of(out_side);
  const double t = combined_share(mesh, end, r);
  Cubic<Value> joined{in.p0, in.m0 * (1 / t), out.m1 * (1 / (1 - t)), out.p1};
  if (mesh.color_model() == ColorModel::bilinear)
    joined.m0.color = joined.m1.color = joined.p1.color - joined.p0.color;
  const double scale = length(in) + length(out);
  double sum = 0;
  for (int i = 1; i <= steps; ++i) {
    const double s = double(i) / steps;
    for (const Value& d : {joined.at(t * s) - in.at(s), joined.at(t + (1 - t) * s) - out.at(s)}) {
      const double off = scale > 0 ? glm::length(d.position) / scale : 0;
      sum += off * off + glm::dot(d.color, d.color);
    }
  }
  return sum;
}

}  // namespace

double split_factor(const Mesh& mesh, Halfedge edge) {
  const Halfedge twin = mesh[edge].twin;
  const MergeEnd tail = merge_end(mesh, edge), head = merge_end(mesh, twin);
  double sum = 0;
  int ends = 0;
  // A stem stands where its parent was split, so only the other end is estimated; between two
  // stems the parents' intervals are all there is to know.
  if (tail.kind != MergeEnd::stem) {
    sum += estimates(mesh, edge, tail).mean();
    ++ends;
  }
  if (head.kind != MergeEnd::stem) {
    sum += 1 - estimates(mesh, twin, head).mean();
    ++ends;
  }
  const double r =
      ends > 0 ? sum / ends : 0.5 * (bar_share(mesh, tail) + 1 - bar_share(mesh, head));
  return std::clamp(r, smallest_share, 1 - smallest_share);
}

double split_share(const Mesh& mesh, Halfedge edge, const MergeEnd& end, double r) {
  if (end.kind == MergeEnd::stem) return bar_share(mesh, end);
  const Estimates own = estimates(mesh, edge, end);
  double best = r, least = deviation(mesh, end, r);
  for (const double other : {own.mean(), own.at_corner, own.inside, own.by_length}) {
    const double candidate = std::clamp(other, smallest_share, 1 - smallest_share);
    // What differs by roundings only is no reason to leave Eq. 4.
    if (const double d = deviation(mesh, end, candidate); d < 0.99 * least - 1e-20) {
      best = candidate;
      least = d;
    }
  }
  return best;
}

}  // namespace gradmesh
