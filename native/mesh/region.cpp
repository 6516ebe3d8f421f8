#include "mesh/region.h"

#include <algorithm>

namespace gradmesh {

Halfedge leaf_across(const Mesh& mesh, Halfedge leaf) {
  if (mesh.is_bar(leaf)) return {};
  const Halfedge twin = mesh[leaf].twin;
  return twin.valid() && mesh.is_leaf(twin) ? twin : Halfedge{};
}

namespace {

/// Returns the top side of the patch to the right of the patch whose top side is `top`; invalid
/// where there is none.
Halfedge to_the_right(const Mesh& mesh, Halfedge top) {
  const Halfedge across = leaf_across(mesh, mesh.next(top));
  return across.valid() ? mesh.next(across) : Halfedge{};
}

Halfedge below(const Mesh& mesh, Halfedge top) {
  return leaf_across(mesh, mesh.next(mesh.next(top)));
}

/// Returns the region that starts at the patch of `top`.
Region region_at(const Mesh& mesh, Halfedge top, int rows, int columns) {
  return {mesh.face(top), mesh.side_number(top), rows, columns};
}

}  // namespace

std::vector<Halfedge> region_tops(const Mesh& mesh, const Region& region) {
  std::vector<Halfedge> tops;
  tops.reserve(region.size());
  std::vector<bool> seen(mesh.face_slots());
  const Halfedge first = mesh.sides(region.face)[region.top];
  const auto add = [&](Halfedge top) {
    // The same patch twice: the region goes round a ring.
    if (!top.valid() || seen[mesh.face(top).value]) return false;
    seen[mesh.face(top).value] = true;
    tops.push_back(top);
    return true;
  };
  for (int i = 0; i < region.rows; ++i)
    for (int j = 0; j < region.columns; ++j) {
      const Halfedge beside = j > 0 ? to_the_right(mesh, tops.back()) : Halfedge{};
      const Halfedge under = i > 0 ? below(mesh, tops[tops.size() - region.columns]) : Halfedge{};
      // Inside, both ways must lead to the same patch: the point between them is regular.
      if (i > 0 && j > 0 && beside != under) return {};
      if (!add(i > 0 ? under : j > 0 ? beside : first)) return {};
    }
  return tops;
}

std::array<Region, 4> region_views(const Mesh& mesh, const Region& region,
                                   const std::vector<Halfedge>& tops) {
  const int rows = region.rows, columns = region.columns;
  const Halfedge top_right = tops[columns - 1],
                 bottom_left = tops[tops.size() - std::size_t(columns)];
  return {region, region_at(mesh, mesh.next(top_right), columns, rows),
          region_at(mesh, mesh.next(mesh.next(tops.back())), rows, columns),
          region_at(mesh, mesh.prev(bottom_left), columns, rows)};
}

Region region_name(const Mesh& mesh, const Region& region, const std::vector<Halfedge>& tops) {
  const std::array<Region, 4> views = region_views(mesh, region, tops);
  return *std::ranges::min_element(views);
}

Region region_of_edge(const Mesh& mesh, Halfedge edge) {
  const Halfedge twin = mesh[edge].twin;
  // The edge is the bottom of the one patch and the top of the other.
  const Halfedge top = mesh.next(mesh.next(edge));
  return region_name(mesh, region_at(mesh, top, 2, 1), {top, twin});
}

}  // namespace gradmesh
