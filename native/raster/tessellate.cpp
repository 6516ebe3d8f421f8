#include "raster/tessellate.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace gradmesh {
namespace {

/// Half of the tenth of a pixel that is promised: outlines and inside add up.
constexpr double flatness = 0.05;
constexpr int most_steps = 2048;

int steps_for(double steps) { return int(std::clamp(std::ceil(steps), 1.0, double(most_steps))); }

/// A cubic's second derivative is at most 6 times the second difference of its control points,
/// and a chord over 1/n of it is off by at most an eighth of that over n^2.
int outline_steps(const Cubic<Value>& curve, const Frame& frame) {
  const glm::dvec2 b0 = curve.p0.position, b1 = curve.bezier1().position;
  const glm::dvec2 b2 = curve.bezier2().position, b3 = curve.p1.position;
  const double bend = 6 * std::max(glm::length(frame.to_pixels.vector(b0 - 2.0 * b1 + b2)),
                                   glm::length(frame.to_pixels.vector(b1 - 2.0 * b2 + b3)));
  return steps_for(std::sqrt(bend / (8 * flatness)));
}

struct Steps {
  int u, v;
};

/// Linear interpolation over half a cell of size hu x hv is off by at most
/// (|H_uu| hu^2 + 2 |H_uv| hu hv + |H_vv| hv^2) / 8; each term gets a third.
Steps inside_steps(const BezierNet& net, const Frame& frame) {
  const auto p = [&](int i, int j) { return net[i][j].position; };
  const auto size = [&](glm::dvec2 d) { return glm::length(frame.to_pixels.vector(d)); };
  double uu = 0, vv = 0, uv = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      if (i < 2) uu = std::max(uu, 6 * size(p(i, j) - 2.0 * p(i + 1, j) + p(i + 2, j)));
      if (j < 2) vv = std::max(vv, 6 * size(p(i, j) - 2.0 * p(i, j + 1) + p(i, j + 2)));
      if (i < 3 && j < 3)
        uv = std::max(uv, 9 * size(p(i, j) - p(i + 1, j) - p(i, j + 1) + p(i + 1, j + 1)));
    }
  constexpr double third = 8 * flatness / 3;
  double u = std::max(1.0, std::sqrt(uu / third)), v = std::max(1.0, std::sqrt(vv / third));
  const double lacking = 2 * uv / third / (u * v);
  if (lacking > 1) {
    u *= std::sqrt(lacking);
    v *= std::sqrt(lacking);
  }
  // A grid needs a vertex inside.
  return {std::max(2, steps_for(u)), std::max(2, steps_for(v))};
}

Vertex vertex(glm::dvec2 position, double u, double v, const Frame& frame) {
  constexpr double unit = 1 << subpixel_bits;
  const glm::dvec2 p = frame.to_pixels.point(position);
  // Far outside every frame, and products of two differences still fit into 64 bits.
  const auto snap = [](double x) {
    return std::int64_t(std::llround(std::clamp(x, -1e6, 1e6) * unit));
  };
  return {snap(p.x), snap(p.y), float(u), float(v)};
}

/// Fills the strip between two rows of vertices that run the same way, `outer` to their left.
/// `along` tells how far a vertex is along the strip.
template <class Along>
void add_strip(const std::vector<Vertex>& outer, const std::vector<Vertex>& inner,
               const Along& along, std::vector<Triangle>& triangles) {
  std::size_t i = 0, j = 0;
  while (i + 1 < outer.size() || j + 1 < inner.size()) {
    const bool step_outer = j + 1 == inner.size() ||
                            (i + 1 < outer.size() && along(outer[i]) + along(outer[i + 1]) <=
                                                         along(inner[j]) + along(inner[j + 1]));
    if (step_outer) {
      triangles.push_back({outer[i], outer[i + 1], inner[j]});
      ++i;
    } else {
      triangles.push_back({outer[i], inner[j + 1], inner[j]});
      ++j;
    }
  }
}

std::int64_t doubled_area(const Triangle& t) {
  return (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y);
}

/// Where a patch folds over itself, the larger v and then the larger u lies on top, as the
/// documentation of cairo's mesh patterns and PDF 32000-1, 8.7.4.5.7, have it.
void order_where_folded(std::vector<Triangle>& triangles) {
  bool left = false, right = false;
  for (const Triangle& t : triangles) {
    const std::int64_t area = doubled_area(t);
    left = left || area > 0;
    right = right || area < 0;
  }
  if (!(left && right)) return;
  const auto key = [](const Triangle& t) {
    return std::pair(t[0].v + t[1].v + t[2].v, t[0].u + t[1].u + t[2].u);
  };
  std::ranges::stable_sort(triangles, {}, key);
}

}  // namespace

void Outlines::prepare(Halfedge leaf) {
  const Halfedge curve = mesh_.curve(leaf);
  const auto [place, is_new] = cuts_.try_emplace(curve);
  if (!is_new) return;

  std::vector<Cut>& cuts = place->second;
  const Halfedge twin = mesh_[curve].twin;
  const Cubic<Value> cubic = mesh_.curve_of(curve);
  cuts.push_back({0, mesh_.position(mesh_.origin(curve))});
  cuts.push_back({1, mesh_.position(mesh_.end(curve))});
  for (const Halfedge stem : mesh_.stems(curve))
    cuts.push_back({mesh_[stem].interval.first, mesh_.position(mesh_.origin(stem))});
  if (twin.valid())
    for (const Halfedge stem : mesh_.stems(twin))
      cuts.push_back({1 - mesh_[stem].interval.first, mesh_.position(mesh_.origin(stem))});
  const int steps = outline_steps(cubic, frame_);
  for (int i = 1; i < steps; ++i) {
    const double t = double(i) / steps;
    cuts.push_back({t, cubic.at(t).position});
  }
  std::ranges::stable_sort(cuts, {}, &Cut::t);
  // T-junctions of both sides in one place are one cut, and an even cut beside one is none.
  const auto same = [](const Cut& a, const Cut& b) { return b.t - a.t < 1e-9; };
  cuts.erase(std::unique(cuts.begin(), cuts.end(), same), cuts.end());
}

std::vector<Outlines::Cut> Outlines::along(Halfedge leaf) const {
  const Halfedge curve = mesh_.curve(leaf);
  const bool backwards = mesh_.curve_side(leaf) != curve;
  Interval span = mesh_.span(leaf);
  if (backwards) span = {1 - span.second, 1 - span.first};
  std::vector<Cut> result;
  for (const Cut& cut : cuts_.at(curve))
    if (cut.t > span.first - 1e-9 && cut.t < span.second + 1e-9)
      result.push_back({std::clamp((cut.t - span.first) / span.length(), 0.0, 1.0), cut.position});
  if (backwards) {
    std::ranges::reverse(result);
    for (Cut& cut : result) cut.t = 1 - cut.t;
  }
  return result;
}

std::vector<Triangle> tessellate(const Mesh& mesh, Face face, const Patch& patch,
                                 const Frame& frame, const Outlines& outlines) {
  const Steps steps = inside_steps(bezier_net(patch), frame);
  const int nu = steps.u, nv = steps.v;
  std::vector<Vertex> grid;
  for (int j = 1; j < nv; ++j)
    for (int i = 1; i < nu; ++i) {
      const double u = double(i) / nu, v = double(j) / nv;
      grid.push_back(vertex(patch.at(u, v).position, u, v, frame));
    }
  const auto inside = [&](int i, int j) { return grid[(j - 1) * (nu - 1) + (i - 1)]; };

  std::vector<Triangle> triangles;
  triangles.reserve(2 * nu * nv);
  const std::array<Halfedge, 4> sides = mesh.sides(face);
  for (int k = 0; k < 4; ++k) {
    std::vector<Vertex> outer, inner;
    for (const Outlines::Cut& cut : outlines.along(sides[k])) {
      const double u = k == 0 ? 0 : k == 1 ? cut.t : k == 2 ? 1 : 1 - cut.t;
      const double v = k == 0 ? cut.t : k == 1 ? 1 : k == 2 ? 1 - cut.t : 0;
      outer.push_back(vertex(cut.position, u, v, frame));
    }
    if (k == 0)
      for (int j = 1; j < nv; ++j) inner.push_back(inside(1, j));
    else if (k == 1)
      for (int i = 1; i < nu; ++i) inner.push_back(inside(i, nv - 1));
    else if (k == 2)
      for (int j = nv - 1; j > 0; --j) inner.push_back(inside(nu - 1, j));
    else
      for (int i = nu - 1; i > 0; --i) inner.push_back(inside(i, 1));
    const float direction = k < 2 ? 1.f : -1.f;
    const auto along = [&](const Vertex& x) { return direction * (k % 2 == 0 ? x.v : x.u); };
    add_strip(outer, inner, along, triangles);
  }
  for (int j = 1; j + 1 < nv; ++j)
    for (int i = 1; i + 1 < nu; ++i) {
      triangles.push_back({inside(i, j), inside(i, j + 1), inside(i + 1, j)});
      triangles.push_back({inside(i + 1, j + 1), inside(i + 1, j), inside(i, j + 1)});
    }
  order_where_folded(triangles);
  return triangles;
}

}  // namespace gradmesh
