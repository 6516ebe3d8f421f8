#include "ops/merge/region_finder.h"

#include <algorithm>
#include <utility>

namespace gradmesh {

std::optional<FoundRegion> RegionFinder::around(Halfedge curve) {
  const Halfedge leaf = start_.first_leaf(start_.curve_side(curve));
  const Face face = start_.face(leaf);
  return take_back(grow(journal_, face, start_.side_number(leaf)) ? face : Face{});
}

std::array<std::optional<MergedArea>, 4> RegionFinder::larger(const Region& region) {
  std::array<std::optional<MergedArea>, 4> areas;
  const Face face = merge_region(journal_, region);
  const std::size_t depth = journal_.depth();
  for (int side = 0; side < 4 && face.valid(); ++side) {
    if (grow(journal_, face, region.top + side)) areas[std::size_t(side)] = area_of(face);
    journal_.undo_to(depth);
  }
  undo();
  return areas;
}

std::optional<FoundRegion> RegionFinder::find(const Region& region) {
  return take_back(merge_region(journal_, region));
}

std::optional<FoundRegion> RegionFinder::take_back(Face merged) {
  std::optional<MergedArea> area;
  if (merged.valid()) area = area_of(merged);
  undo();
  return area ? named(*area) : std::nullopt;
}

MergedArea RegionFinder::area_of(Face merged) const {
  MergedArea area{merged_faces(merged), {}};
  for (std::size_t k = 0; k < 4; ++k) area.corners[k] = copy_.origin(copy_.sides(merged)[k]);
  return area;
}

std::optional<FoundRegion> RegionFinder::named(const MergedArea& area) {
  const auto& [faces, corners] = area;
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
