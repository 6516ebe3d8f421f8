#include "mesh/dependence.h"

#include <algorithm>
#include <unordered_set>

namespace gradmesh {

std::vector<Halfedge> supports(const Mesh& mesh, Halfedge curve) {
  std::vector<Halfedge> result;
  for (const Point p : {mesh.origin(curve), mesh.end(curve)})
    if (mesh[p].is_junction()) result.push_back(mesh.curve(mesh[mesh[p].stem].parent));
  return result;
}

std::vector<Halfedge> dependents(const Mesh& mesh, Halfedge curve) {
  std::vector<Halfedge> result;
  const Halfedge side = mesh.curve_side(curve);
  for (const Halfedge s : {side, mesh[side].twin})
    if (s.valid())
      for (const Halfedge stem : mesh.stems(s)) result.push_back(mesh.curve(stem));
  return result;
}

std::vector<Halfedge> in_order_of_dependence(const Mesh& mesh,
                                             const std::vector<Halfedge>& curves) {
  // Depth first; a curve is listed once all that hangs on it is, and the list is turned round.
  struct Visit {
    Halfedge curve;
    std::vector<Halfedge> dependents;
    std::size_t done = 0;
  };
  std::vector<Halfedge> order;
  std::unordered_set<int> seen;
  std::vector<Visit> path;
  const auto enter = [&](Halfedge curve) {
    if (seen.insert(curve.value).second) path.push_back({curve, dependents(mesh, curve)});
  };
  for (const Halfedge start : curves) {
    enter(start);
    while (!path.empty()) {
      Visit& top = path.back();
      if (top.done < top.dependents.size()) {
        enter(top.dependents[top.done++]);
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
  std::vector<Halfedge> curves;
  for (const Halfedge h : mesh.halfedges())
    if (!mesh.is_bar(h) && mesh.curve(h) == h) curves.push_back(h);
  std::vector<int> place(mesh.halfedge_slots());
  const std::vector<Halfedge> order = in_order_of_dependence(mesh, curves);
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i].value] = int(i);
  // In a mesh without cycles, and only there, everything comes after what it hangs on.
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
