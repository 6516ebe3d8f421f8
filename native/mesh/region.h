#pragma once

#include <array>
#include <compare>
#include <vector>

#include "mesh/mesh.h"

namespace gradmesh {

/// A tensor product region (paper 6.3): an area bounded by four curves, which can be merged into
/// one patch. It starts at the patch `face`, whose side `top` (counted as in Mesh::sides) is the
/// region's top there. From `face` the region is `columns` - 1 steps wide to the right, and then
/// `rows` - 1 steps high downwards. Where nothing but whole edges and regular points is inside, a
/// step is one column or row of patches. In general a step takes in the smallest area that lies
/// across all of the curve, whatever T-junctions are inside (ops/merge/merge_region.h). A region
/// stays the same while patches around it are merged.
struct Region {
  Face face;
  int top = 0;
  int rows = 1, columns = 1;

  /// Returns the number of patches, where no T-junction is inside.
  int size() const { return rows * columns; }
  auto operator<=>(const Region&) const = default;
};

/// Returns the top sides of the region's patches, row by row. Returns none where there is no such
/// region without T-junctions inside: at boundaries, T-junctions and irregular points, and where
/// the region would meet itself round a ring.
std::vector<Halfedge> region_tops(const Mesh& mesh, const Region& region);

/// Returns the region as seen from each of its four corners, clockwise from its own. `tops` as of
/// region_tops.
std::array<Region, 4> region_views(const Mesh& mesh, const Region& region,
                                   const std::vector<Halfedge>& tops);

/// Returns the view that names a region: the smallest of the four.
Region region_name(const Mesh& mesh, const Region& region, const std::vector<Halfedge>& tops);

/// Returns the name of the region of the two patches beside an edge. The edge and its twin are
/// leaves.
Region region_of_edge(const Mesh& mesh, Halfedge edge);

/// Returns the leaf across a leaf where the edge is one edge from both sides; otherwise an invalid
/// half-edge.
Halfedge leaf_across(const Mesh& mesh, Halfedge leaf);

}  // namespace gradmesh
