#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ops/merge/merge_region.h"

namespace gradmesh {

/// The name of a region, and its patches in rising order.
struct FoundRegion {
  Region name;
  std::vector<Face> faces;
};

/// An area that can be merged into one patch: its patches in rising order, and its corners.
struct MergedArea {
  std::vector<Face> faces;
  std::array<Point, 4> corners;
};

/// Finds regions by merging them on a copy of the mesh, also those with T-junctions inside; for the
/// others region_tops is quicker. An area that cannot be merged is no region.
class RegionFinder {
 public:
  explicit RegionFinder(const Mesh& mesh) : start_(mesh), copy_(mesh), journal_(copy_) {}
  RegionFinder(const RegionFinder&) = delete;
  RegionFinder& operator=(const RegionFinder&) = delete;

  /// Returns the smallest region that has the whole curve inside, if there is one.
  std::optional<FoundRegion> around(Halfedge curve);
  /// Returns the smallest areas that have this region inside and lie across one of its sides, that
  /// of its top first and the others clockwise.
  std::array<std::optional<MergedArea>, 4> larger(const Region& region);
  /// Returns an area as a region; nothing if it has no name that gives the same patches.
  std::optional<FoundRegion> named(const MergedArea& area);
  /// Returns the region by its name, from whichever corner `region` is seen.
  std::optional<FoundRegion> find(const Region& region);

 private:
  /// Returns the area that has become the patch `merged`.
  MergedArea area_of(Face merged) const;
  /// Returns the region that has become the patch `merged`, after undoing the merges. Returns
  /// nothing if `merged` is invalid or the region has no name.
  std::optional<FoundRegion> take_back(Face merged);
  /// Merges the area from the corner at which side `top` of a patch starts to the next two corners
  /// `right` and `bottom`. Returns the area as a region if it is one.
  std::optional<Region> view_from(Face face, int top, Point right, Point bottom);
  std::vector<Face> merged_faces(Face merged) const;
  void undo();

  const Mesh& start_;
  Mesh copy_;
  Journal journal_;
};

}  // namespace gradmesh
