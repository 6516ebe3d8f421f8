#pragma once

#include <gtest/gtest.h>

#include "mesh/mesh.h"

namespace gradmesh::test {

inline std::size_t junctions(const Mesh& mesh) {
  std::size_t count = 0;
  for (const Point p : mesh.points()) count += mesh[p].is_junction();
  return count;
}

/// The leaves of all faces, each face from its top: in two equal meshes they correspond.
inline std::vector<Halfedge> leaves_of_faces(const Mesh& mesh) {
  std::vector<Halfedge> leaves;
  for (const Face f : mesh.faces())
    for (const Halfedge h : mesh.sides(f)) leaves.push_back(h);
  return leaves;
}

/// Without opacity, which the format does not hold (after splits it is 1 up to rounding).
inline Value solid(Value v) {
  v.color.a = 0;
  return v;
}
inline Cubic<Value> solid(const Cubic<Value>& c) {
  return {solid(c.p0), solid(c.m0), solid(c.m1), solid(c.p1)};
}
inline Patch solid(Patch patch) {
  for (auto& row : patch.c)
    for (Value& v : row) v = solid(v);
  return patch;
}

/// Bit for bit, up to opacity and the order of what is no face.
inline ::testing::AssertionResult same(const Mesh& a, const Mesh& b) {
  const auto sizes = [](const Mesh& mesh) {
    return std::array{std::ranges::distance(mesh.faces()), std::ranges::distance(mesh.points()),
                      std::ranges::distance(mesh.handles()),
                      std::ranges::distance(mesh.halfedges())};
  };
  if (sizes(a) != sizes(b)) return ::testing::AssertionFailure() << "the sizes differ";
  const std::vector<Halfedge> in_a = leaves_of_faces(a), in_b = leaves_of_faces(b);
  for (std::size_t i = 0; i < in_a.size(); ++i) {
    const Halfedge h = in_a[i], g = in_b[i];
    const auto differ = [&](const char* what) {
      return ::testing::AssertionFailure() << what << " of side " << i << " differs";
    };
    const bool junction = a[a.origin(h)].is_junction();
    if (junction != b[b.origin(g)].is_junction())
      return differ("whether a T-junction is the start");
    if (a.position(a.origin(h)) != b.position(b.origin(g))) return differ("the start");
    if (glm::dvec3(a[h].color) != glm::dvec3(b[g].color)) return differ("the colour");
    if (junction && a[h].own_color != b[g].own_color) return differ("whose the colour is");
    if (solid(a[h].twist) != solid(b[g].twist)) return differ("the twist");
    if (a.span(h) != b.span(g)) return differ("the interval");
    if (a.other_side(h).valid() != b.other_side(g).valid()) return differ("the boundary");
    if (solid(a.curve_of(a.curve_side(h))) != solid(b.curve_of(b.curve_side(g))))
      return differ("the curve");
    if (solid(a.patch(a.face(h))) != solid(b.patch(b.face(g)))) return differ("the patch");
  }
  return ::testing::AssertionSuccess();
}

}  // namespace gradmesh::test
