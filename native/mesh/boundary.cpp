#include "mesh/boundary.h"

#include <algorithm>
#include <map>

namespace gradmesh {

std::vector<std::vector<Halfedge>> boundary_loops(const Mesh& mesh) {
  std::multimap<Point, Halfedge> starts;
  for (const Halfedge h : mesh.halfedges())
    if (mesh.is_leaf(h) && !mesh.other_side(h).valid()) starts.emplace(mesh.origin(h), h);
  // As many leaves of the boundary start at a point as end there: a walk ends where it began.
  std::vector<std::vector<Halfedge>> loops;
  while (!starts.empty()) {
    std::vector<Halfedge>& loop = loops.emplace_back();
    for (auto at = starts.begin(); at != starts.end(); at = starts.find(mesh.end(loop.back()))) {
      loop.push_back(at->second);
      starts.erase(at);
    }
  }
  return loops;
}

std::vector<int> face_components(const Mesh& mesh, const std::function<bool(Halfedge)>& divides) {
  std::vector<int> component(mesh.face_slots(), -1);
  int count = 0;
  for (const Face start : mesh.faces()) {
    if (component[start.value] >= 0) continue;
    std::vector<Face> waiting{start};
    component[start.value] = count;
    while (!waiting.empty()) {
      const Face face = waiting.back();
      waiting.pop_back();
      for (const Halfedge h : mesh.sides(face)) {
        if (divides(h)) continue;
        const Halfedge side = mesh.curve_side(h), twin = mesh[side].twin;
        for (const Halfedge s : {side, twin}) {
          if (!s.valid()) continue;
          for (const Halfedge leaf : mesh.leaves(s)) {
            const Face beside = mesh.face(leaf);
            if (component[beside.value] >= 0) continue;
            component[beside.value] = count;
            waiting.push_back(beside);
          }
        }
      }
    }
    ++count;
  }
  return component;
}

std::vector<Halfedge> outer_sides(const Mesh& mesh, const std::vector<Face>& faces) {
  std::vector<bool> is_one(mesh.face_slots(), false);
  for (const Face face : faces) is_one[std::size_t(face.value)] = true;
  const auto is_inside = [&](Halfedge leaf) { return is_one[std::size_t(mesh.face(leaf).value)]; };
  std::vector<Halfedge> outer;
  for (const Face face : faces)
    for (const Halfedge side : mesh.sides(face)) {
      const Halfedge across = mesh.other_side(side);
      if (!across.valid() || !std::ranges::all_of(mesh.leaves(across), is_inside))
        outer.push_back(side);
    }
  return outer;
}

Box bounding_box(const Mesh& mesh, const Affine& view) {
  Box box;
  for (const Face f : mesh.faces())
    for (const Halfedge h : mesh.sides(f)) {
      const Cubic<Value> side = mesh.side_of(h);
      box.add_cubic(view.point(side.p0.position), view.point(side.bezier1().position),
                    view.point(side.bezier2().position), view.point(side.p1.position));
    }
  return box;
}

}  // namespace gradmesh
