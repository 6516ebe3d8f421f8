#include "app/pages/tiles_of_meshes.h"

#include <algorithm>
#include <span>

#include "app/pages/mesh_among_tiles.h"
#include "mesh/boundary.h"

namespace gradmesh {
namespace {

/// The largest difference at which tiles show the same as a mesh.
constexpr double same_look = 0.05;
/// The least share of the box around both that each of their boxes has.
constexpr double least_overlap = 0.8;
/// How many pictures are compared at most; what is left then stays beside its mesh.
constexpr int most_comparisons = 1000;
/// Of fewer tiles each may be drawn for itself.
constexpr int fewest_tiles = 4;

double area(const Box& box) { return box.empty() ? 0 : box.size().x * box.size().y; }

bool lie_together(const Box& a, const Box& b) {
  return area(overlap(a, b)) >= least_overlap * std::max(area(a), area(b));
}

/// Tiles that follow one another, of which meshes take theirs.
class Run {
 public:
  explicit Run(const FlatTiles& tiles)
      : tiles_(tiles), box_(box_of(tiles.tiles)), taken_(tiles.tiles.size()) {}

  /// Returns true if there are as many as a mesh has patches, where its box lies.
  bool may_hold(const Box& mesh, int patches) const {
    return taken_.size() >= std::size_t(patches) && !overlap(box_, mesh).empty();
  }
  std::span<const FlatArea> part(const MeshAmongTiles::Part& part) const {
    return std::span(tiles_.tiles).subspan(part.begin, part.count());
  }
  MeshAmongTiles::Part all() const { return {0, taken_.size()}; }
  /// Returns true if all of them are a group, of which nothing was taken.
  bool is_whole_group() const {
    return tiles_.group && std::ranges::find(taken_, true) == taken_.end();
  }
  MeshAmongTiles::Part longest_part(const MeshAmongTiles& mesh) const {
    return mesh.longest_part(tiles_.tiles, taken_);
  }
  PartOfTiles take(const MeshAmongTiles::Part& part) {
    for (std::size_t n = part.begin; n < part.end; ++n) taken_[n] = true;
    return {&tiles_, part.begin, part.end};
  }

 private:
  const FlatTiles& tiles_;
  const Box box_;
  std::vector<bool> taken_;
};

class TileSearch {
 public:
  explicit TileSearch(const std::vector<FlatTiles>& runs) : runs_(runs.begin(), runs.end()) {}

  /// Returns true if there may be tiles of a mesh in a box.
  bool may_have_some_in(const Box& box, int patches) const {
    return std::ranges::any_of(runs_, [&](const Run& run) { return run.may_hold(box, patches); });
  }

  /// Returns the tiles that show the same as a mesh with so many patches on its page.
  PartOfTiles take(const MeshAmongTiles& mesh, int patches) {
    double least = same_look;
    Run* best = nullptr;
    MeshAmongTiles::Part its;
    const auto is_better = [&](Run& run, const MeshAmongTiles::Part& part) {
      // The import makes one tile of a patch, or several.
      if (part.count() < std::size_t(std::max(patches, fewest_tiles)) ||
          !lie_together(mesh.box(), box_of(run.part(part))) || ++comparisons_ > most_comparisons)
        return false;
      const double apart = mesh.difference_to(run.part(part));
      if (apart > least) return false;
      least = apart;
      best = &run;
      its = part;
      return true;
    };
    for (Run& run : runs_) {
      if (!run.may_hold(mesh.box(), patches)) continue;
      if (!run.is_whole_group() || !is_better(run, run.all()))
        is_better(run, run.longest_part(mesh));
    }
    return best ? best->take(its) : PartOfTiles();
  }

 private:
  std::vector<Run> runs_;
  int comparisons_ = 0;
};

}  // namespace

std::vector<PartOfTiles> tiles_of_meshes(const std::vector<PageObject>& objects,
                                         const std::vector<Affine>& places,
                                         const std::vector<FlatTiles>& runs) {
  std::vector<PartOfTiles> found;
  TileSearch search(runs);
  for (const PageObject& object : objects) {
    found.emplace_back();
    const Affine& place = places[object.page];
    if (object.stroke || place.determinant() == 0 ||
        !search.may_have_some_in(bounding_box(object.mesh, place), object.patches))
      continue;
    found.back() = search.take(MeshAmongTiles(object.mesh, place), object.patches);
  }
  return found;
}

}  // namespace gradmesh
