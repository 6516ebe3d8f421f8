#include "form/handles.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "form/rounding.h"
#include "form/written_patch.h"
#include "geom/box.h"

namespace gradmesh {

namespace {

Box box_of(const Mesh& mesh) {
  Box box;
  for (const Point p : mesh.points()) box.add(mesh.position(p));
  return box;
}

double rounding_of(const Box& box) {
  constexpr double share = 1e-6;
  return share * (box.size().x + box.size().y);
}

}  // namespace

double rounding_of(const Mesh& mesh) { return rounding_of(box_of(mesh)); }

double last_bits_of(const Mesh& mesh) {
  double largest = 0;
  for (const Point p : mesh.points())
    for (const double x : {mesh.position(p).x, mesh.position(p).y})
      largest = std::max(largest, std::abs(x));
  return share_of_last_bits * largest;
}

bool is_straight(const Cubic<Value>& curve, double tolerance) {
  const glm::dvec2 chord = curve.p1.position - curve.p0.position;
  return glm::length(curve.m0.position - chord) <= 3 * tolerance &&
         glm::length(curve.m1.position - chord) <= 3 * tolerance;
}

int count_handles(const Mesh& surface) {
  const Box box = box_of(surface);
  const double same = rounding_of(box);
  std::set<std::pair<long long, long long>> places;
  const auto add = [&](glm::dvec2 p) {
    const glm::dvec2 q = (p - box.low()) / same;
    places.emplace(std::llround(q.x), std::llround(q.y));
  };
  for (const Face f : surface.faces()) {
    const Patch patch = surface.patch(f);
    for (int k = 0; k < 4; ++k) {
      const Cubic<Value> side = patch.side(k);
      add(side.p0.position);
      if (is_straight(side, same)) continue;
      add(side.bezier1().position);
      add(side.bezier2().position);
    }
    if (!needs_tensor(patch, same)) continue;
    const BezierNet net = bezier_net(patch);
    for (const int i : {1, 2})
      for (const int j : {1, 2}) add(net[i][j].position);
  }
  return int(places.size());
}

}  // namespace gradmesh
