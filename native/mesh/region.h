#pragma once

#include <array>
#include <compare>
#include <vector>

#include "mesh/mesh.h"

namespace gradmesh {

/// A tensor product region (paper 6.3): an area bounded by four curves, which can be merged into
/// one patch. It starts at the patch `face`, whose side `top` (counted as in Mesh::sides) is its
/// top there. From there it is `columns` - 1 steps wide to the right, and then `rows` - 1 steps
/// high downwards. Where it has nothing but whole edges and regular points inside, a step is one
/// column or row of patches. In general a step takes in the smallest area that lies across all of
/// the curve, whatever T-junctions are inside (ops/merge/merge_region.h). A region stays what it is
/// while patches around it are merged.
struct Region {
  Face face;
  int top = 0;
  int rows = 1, columns = 1;

  /// In patches, where no T-junction is inside.
  int size() const { return rows * columns; }
  auto operator<=>(const Region&) const = default;
};

/// The top sides of the region's patches, row by row. Empty where there is no such region without
/// T-junctions inside: at boundaries, T-junctions and irregular points, and where it would meet
/// itself round a ring.
std::vector<Halfedge> region_tops(const Mesh& mesh, const Region& region);

/// The region as seen from each of its four corners, clockwise from its own. `tops` as of
/// region_tops.
std::array<Region, 4> region_views(const Mesh& mesh, const Region& region,
                                   const std::vector<Halfedge>& tops);

/// The view by which a region is known: the smallest of the four.
Region region_name(const Mesh& mesh, const Region& region, const std::vector<Halfedge>& tops);

/// The two patches beside an edge as a region, by its name. The edge and its twin are leaves.
Region region_of_edge(const Mesh& mesh, Halfedge edge);

/// The leaf across a leaf, where the edge is one edge from both sides; otherwise invalid.
Halfedge leaf_across(const Mesh& mesh, Halfedge leaf);

}  // namespace gradmesh
