#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "formats/pdf/grid/page_patch.h"
#include "formats/pdf/grid/welded_points.h"

namespace gradmesh {

/// A patch as it lies in a grid: listed from corner `first` on, or from there the other way around.
struct LaidPatch {
  int patch = 0;
  int first = 0;
  bool is_mirrored = false;

  bool operator==(const LaidPatch&) const = default;
};

/// Returns a patch as it lies.
PagePatch laid(const PagePatch& patch, const LaidPatch& lies);

/// Returns twice the area that its corners surround as it lies, negative where they lie
/// counterclockwise (y down).
double area_of(const PagePatch& patch, const LaidPatch& lies);

/// Which sides of loose patches are one curve, with the same colours at its ends.
class PatchSides {
 public:
  /// Moves points that are one to the same place.
  PatchSides(std::vector<PagePatch> patches, double tolerance);

  const std::vector<PagePatch>& patches() const { return patches_; }
  /// Returns the patch beyond a side of one that lies so, as it lies beside it; nothing where there
  /// is none, or more than one, or it lies over that one.
  std::optional<LaidPatch> beyond(const LaidPatch& here, std::size_t side) const;

 private:
  using Curve = std::array<int, 4>;
  using Points = std::array<int, PagePatch::outer_count>;

  Curve side_of(const LaidPatch& lies, std::size_t side) const;
  bool has_same_colors(const LaidPatch& a, std::size_t side_a, const LaidPatch& b,
                       std::size_t side_b) const;

  std::vector<PagePatch> patches_;
  std::vector<Points> points_;
  /// The patches that have a curve as a side, listed the way in which it is smaller.
  std::map<Curve, std::vector<int>> owners_;
};

}  // namespace gradmesh
