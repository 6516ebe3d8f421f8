#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ops/merge/merge_region.h"

namespace gradmesh {

/// A region by its name, and its patches in rising order.
struct FoundRegion {
  Region name;
  std::vector<Face> faces;
};

/// Finds regions that have T-junctions inside, by merging them on a copy of the mesh; others too,
/// though region_tops is quicker there. What cannot be merged is no region.
class RegionFinder {
 public:
  explicit RegionFinder(const Mesh& mesh) : start_(mesh), copy_(mesh), journal_(copy_) {}
  RegionFinder(const RegionFinder&) = delete;
  RegionFinder& operator=(const RegionFinder&) = delete;

  /// The smallest region that has the whole curve inside.
  std::optional<FoundRegion> around(Halfedge curve);
  /// The smallest regions that have this one inside and lie across one of its sides, that of its
  /// top and the others clockwise.
  std::array<std::optional<FoundRegion>, 4> larger(const Region& region);
  /// The same region by its name, from whichever corner it is seen.
  std::optional<FoundRegion> find(const Region& region);

 private:
  /// The region that has become the patch `merged`; takes the merges back.
  std::optional<FoundRegion> take_back(Face merged);
  /// Merges what lies between the corner at which the side of a patch starts and the next two;
  /// returns that as a region if it is one.
  std::optional<Region> view_from(Face face, int top, Point right, Point bottom);
  std::vector<Face> merged_faces(Face merged) const;
  void undo();

  const Mesh& start_;
  Mesh copy_;
  Journal journal_;
};

}  // namespace gradmesh
