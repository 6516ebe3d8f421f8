#include "ops/merge/region_finder.h"

#include <algorithm>
#include <utility>

namespace gradmesh {

std::optional<FoundRegion> RegionFinder::around(Halfedge curve) {
  const Halfedge leaf = start_.first_leaf(start_.curve_side(curve));
  const Face face = start_.face(leaf);
  return take_back(grow(journal_, face, start_.side_number(leaf)) ? face : Face{});
}

std::array<std::optional<FoundRegion>, 4> RegionFinder::larger(const Region& region) {
  std::array<std::optional<FoundRegion>, 4> found;
  for (int side = 0; side < 4; ++side) {
    Face face = merge_region(journal_, region);
    if (face.valid() && !grow(journal_, face, region.top + side)) face = {};
    found[std::size_t(side)] = take_back(face);
  }
  return found;
}

std::optional<FoundRegion> RegionFinder::find(const Region& region) {
  return take_back(merge_region(journal_, region));
}

std::optional<FoundRegion> RegionFinder::take_back(Face merged) {
  if (!merged.valid()) {
    undo();
    return std::nullopt;
  }
  const std::vector<Face> faces = merged_faces(merged);
  std::array<Point, 4> corners;
  for (std::size_t k = 0; k < 4; ++k) corners[k] = copy_.origin(copy_.sides(merged)[k]);
  undo();

  // The name starts at the corner whose patch comes first (region_name).
  for (const Face face : faces)
    for (int top = 0; top < 4; ++top) {
      const Point start = start_.origin(start_.sides(face)[std::size_t(top)]);
      const auto corner = std::size_t(std::ranges::find(corners, start) - corners.begin());
      if (corner == 4) continue;
      const std::optional<Region> name =
          view_from(face, top, corners[(corner + 1) % 4], corners[(corner + 2) % 4]);
      const bool same = name && merged_faces(face) == faces;
      undo();
      return same ? std::optional(FoundRegion{*name, faces}) : std::nullopt;
    }
  return std::nullopt;
}

std::optional<Region> RegionFinder::view_from(Face face, int top, Point right, Point bottom) {
  Region view{face, top, 1, 1};
  const auto corner = [&](int k) { return copy_.origin(copy_.sides(face)[std::size_t(k % 4)]); };
  for (; corner(top + 1) != right; ++view.columns)
    if (!grow(journal_, face, top + 1)) return std::nullopt;
  for (; corner(top + 2) != bottom; ++view.rows)
    if (!grow(journal_, face, top + 2)) return std::nullopt;
  return view;
}

std::vector<Face> RegionFinder::merged_faces(Face merged) const {
  std::vector<Face> faces = journal_.touched_since(0);
  std::erase_if(faces, [&](Face f) { return f != merged && copy_[f].alive; });
  if (faces.empty()) faces.push_back(merged);
  return faces;
}

void RegionFinder::undo() { journal_.undo_to(0); }

}  // namespace gradmesh
