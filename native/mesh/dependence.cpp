#include "mesh/dependence.h"

#include <algorithm>

namespace gradmesh {

std::vector<Halfedge> supports(const Mesh& mesh, Halfedge curve) {
  std::vector<Halfedge> result;
  for (const Point p : {mesh.origin(curve), mesh.end(curve)})
    if (mesh[p].is_junction()) result.push_back(mesh.curve(mesh[mesh[p].stem].parent));
  return result;
}

std::vector<Halfedge> in_order_of_dependence(const Mesh& mesh, std::span<const Halfedge> curves) {
  // Depth first: a curve is listed after all curves that depend on it, and the list is reversed at
  // the end.
  struct Visit {
    Halfedge curve;
    /// The side of the curve whose stems are visited next, and the first child there not visited
    /// yet.
    Halfedge side, child;
  };
  std::vector<Halfedge> order;
  std::vector<bool> seen(mesh.halfedge_slots());
  std::vector<Visit> path;
  const auto enter = [&](Halfedge curve) {
    if (seen[curve.value]) return;
    seen[curve.value] = true;
    path.push_back({curve, curve, mesh[curve].first_child});
  };
  for (const Halfedge start : curves) {
    enter(start);
    while (!path.empty()) {
      Visit& top = path.back();
      if (top.child.valid()) {
        const Halfedge child = top.child;
        top.child = mesh[child].next_sibling;
        if (mesh.is_stem(child)) enter(mesh.curve(child));
      } else if (const Halfedge twin = mesh[top.curve].twin; top.side != twin && twin.valid()) {
        top.side = twin;
        top.child = mesh[twin].first_child;
      } else {
        order.push_back(top.curve);
        path.pop_back();
      }
    }
  }
  std::reverse(order.begin(), order.end());
  return order;
}

bool has_cycle(const Mesh& mesh) {
  const std::vector<Halfedge> curves = mesh.curves();
  std::vector<int> place(mesh.halfedge_slots());
  const std::vector<Halfedge> order = in_order_of_dependence(mesh, curves);
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i].value] = int(i);
  // In a mesh without cycles, and only there, every curve comes after those it depends on.
  return std::ranges::any_of(curves, [&](Halfedge curve) {
    return std::ranges::any_of(supports(mesh, curve), [&](Halfedge support) {
      return place[support.value] >= place[curve.value];
    });
  });
}

Value junction_value(const Mesh& mesh, Halfedge stem) {
  return mesh.curve_of(mesh[stem].parent).at(mesh[stem].interval.first);
}

}  // namespace gradmesh
