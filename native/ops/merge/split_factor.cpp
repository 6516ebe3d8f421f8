#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "ops/merge/merge.h"
#include "ops/merge/merge_end.h"
#include "ops/merge/split_share.h"

namespace gradmesh {
namespace {

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

}  // namespace

double split_factor(const Mesh& mesh, Halfedge edge) {
  return split_factor(mesh, edge, merge_end(mesh, edge), merge_end(mesh, mesh[edge].twin));
}

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

}  // namespace gradmesh
