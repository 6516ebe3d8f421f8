#include "mesh/mesh.h"

#include <algorithm>
#include <cmath>

namespace gradmesh {

int Mesh::fixed_face_count() const {
  int count = 0;
  for (const Face f : faces()) count += is_fixed(f);
  return count;
}

Halfedge Mesh::last_leaf(Halfedge side) const {
  Halfedge last = side;
  for (Halfedge c = (*this)[side].first_child; c.valid(); c = (*this)[c].next_sibling) last = c;
  return last;
}

std::vector<Halfedge> Mesh::curves() const {
  std::vector<Halfedge> list;
  for (const Halfedge h : halfedges())
    if (curve(h) == h) list.push_back(h);
  return list;
}

std::array<Halfedge, 4> Mesh::sides(Halfedge leaf) const {
  const Halfedge second = next(leaf), third = next(second);
  return {leaf, second, third, next(third)};
}

int Mesh::side_number(Halfedge leaf) const {
  int number = 0;
  for (Halfedge h = (*this)[face(leaf)].halfedge; h != leaf; h = next(h)) ++number;
  return number;
}

Point Mesh::end(Halfedge h) const {
  if (is_leaf(h)) return origin(next(h));
  return origin((*this)[h].twin);
}

Cubic<Value> Mesh::curve_of(Halfedge side) const {
  const HalfedgeRecord& record = (*this)[side];
  Cubic<Value> curve;
  curve.p0 = {position(record.origin), (*this)[first_leaf(side)].color};
  curve.p1 = {position(end(side)), (*this)[next(last_leaf(side))].color};
  curve.m0 = (*this)[record.handles[0]].tangent;
  curve.m1 = -(*this)[record.handles[1]].tangent;
  if (color_model_ == ColorModel::bilinear)
    curve.m0.color = curve.m1.color = curve.p1.color - curve.p0.color;
  return curve;
}

Cubic<Value> Mesh::side_of(Halfedge leaf) const {
  if (!is_bar(leaf)) return curve_of(leaf);
  const Interval interval = (*this)[leaf].interval;
  Cubic<Value> curve = curve_of((*this)[leaf].parent).part(interval.first, interval.second);
  curve.m0.color += (*this)[leaf].own_tangents[0];
  curve.m1.color += (*this)[leaf].own_tangents[1];
  curve.p0 = {position(origin(leaf)), (*this)[leaf].color};
  curve.p1 = {position(end(leaf)), (*this)[next(leaf)].color};
  return curve;
}

Patch Mesh::patch(Halfedge top) const {
  const std::array<Halfedge, 4> around = sides(top);
  std::array<Cubic<Value>, 4> curves;
  std::array<Value, 4> twists;
  for (int k = 0; k < 4; ++k) {
    curves[k] = side_of(around[k]);
    twists[k] = (*this)[around[k]].twist;
  }
  Patch patch = patch_from_sides(curves, twists);
  if (color_model_ == ColorModel::bilinear) make_color_bilinear(patch);
  return patch;
}

bool is_translucent(const Mesh& mesh) {
  return std::ranges::any_of(mesh.halfedges(), [&](Halfedge h) {
    return mesh.is_leaf(h) && std::lround(255 * mesh[h].color.a) != 255;
  });
}

}  // namespace gradmesh
