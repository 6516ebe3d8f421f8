#include "methods/merging/grid.h"

#include <algorithm>
#include <optional>
#include <random>

#include "mesh/region.h"

namespace gradmesh {
namespace {

/// A place in the grid: a leaf that is the far side of its face in the direction of the row.
/// `mirrored` is true if columns are counted against the face's sense of rotation.
struct Place {
  Halfedge ahead;
  bool mirrored;
};

/// The walk over the mesh. With `along_lines` the edges of a line come together (dual-grid),
/// otherwise those of a row.
class GridWalk {
 public:
  GridWalk(const Mesh& mesh, std::uint64_t seed, bool along_lines)
      : mesh_(mesh),
        random_(seed),
        along_lines_(along_lines),
        seen_face_(mesh.face_slots(), false),
        seen_edge_(mesh.halfedge_slots(), false) {}

  std::vector<Halfedge> run() {
    while (const std::optional<Place> start = find_start()) {
      walk(*start);
      walk(turned(*start));
      for (const Place& place : walked_) seen_face_[mesh_.face(place.ahead).value] = true;
      walked_.clear();
    }
    for (const Halfedge h : mesh_.halfedges()) list(h);
    return order_;
  }

 private:
  /// Returns the next side of the same face, in the direction of the next row.
  Halfedge beside(const Place& p) const {
    return p.mirrored ? mesh_.prev(p.ahead) : mesh_.next(p.ahead);
  }
  Place turned(const Place& p) const { return {beside(p), !p.mirrored}; }

  std::optional<Place> next_in_row(const Place& p) const {
    const Halfedge twin = leaf_across(mesh_, p.ahead);
    if (!twin.valid()) return std::nullopt;
    return Place{mesh_.next(mesh_.next(twin)), p.mirrored};
  }
  std::optional<Place> next_row(const Place& p) const {
    const Halfedge twin = leaf_across(mesh_, beside(p));
    if (!twin.valid()) return std::nullopt;
    return Place{p.mirrored ? mesh_.prev(twin) : mesh_.next(twin), p.mirrored};
  }

  /// Walks rows of faces, one after another. A row and the list of rows end at a boundary, at a
  /// T-junction or where they come round to themselves.
  void walk(const Place& start) {
    std::vector<bool> in_rows(mesh_.face_slots(), false);
    std::vector<std::vector<Halfedge>> rows;
    std::optional<Place> row = start;
    while (row && !in_rows[mesh_.face(row->ahead).value]) {
      rows.emplace_back();
      std::optional<Place> place = row;
      while (place && !in_rows[mesh_.face(place->ahead).value]) {
        in_rows[mesh_.face(place->ahead).value] = true;
        rows.back().push_back(place->ahead);
        walked_.push_back(*place);
        place = next_in_row(*place);
      }
      row = next_row(*row);
    }
    along_lines_ ? list_by_lines(rows) : list_by_rows(rows);
  }

  void list_by_rows(const std::vector<std::vector<Halfedge>>& rows) {
    for (const auto& row : rows)
      for (const Halfedge h : row) list(h);
  }
  void list_by_lines(const std::vector<std::vector<Halfedge>>& rows) {
    std::size_t longest = 0;
    for (const auto& row : rows) longest = std::max(longest, row.size());
    for (std::size_t j = 0; j < longest; ++j)
      for (const auto& row : rows)
        if (j < row.size()) list(row[j]);
  }

  void list(Halfedge h) {
    const Halfedge curve = mesh_.curve(h);
    if (seen_edge_[curve.value]) return;
    seen_edge_[curve.value] = true;
    if (mesh_[curve].twin.valid()) order_.push_back(mesh_.curve_side(h));
  }

  /// Returns a corner of the mesh among the faces not yet seen or, without corners, any such face.
  std::optional<Place> find_start() {
    std::vector<Halfedge> corners, others;
    for (const Face f : mesh_.faces()) {
      if (seen_face_[f.value]) continue;
      for (const Halfedge h : mesh_.sides(f)) {
        others.push_back(h);
        if (on_boundary(h) && on_boundary(mesh_.next(h))) corners.push_back(h);
      }
    }
    const std::vector<Halfedge>& choice = corners.empty() ? others : corners;
    if (choice.empty()) return std::nullopt;
    const Halfedge h = choice[random_() % choice.size()];
    // The two sides after the boundary ones: either may be the first direction.
    const Halfedge a = mesh_.next(mesh_.next(h)), b = mesh_.next(a);
    return random_() % 2 == 0 ? Place{a, false} : Place{b, true};
  }

  bool on_boundary(Halfedge leaf) const { return !mesh_.other_side(leaf).valid(); }

  const Mesh& mesh_;
  std::mt19937_64 random_;
  const bool along_lines_;
  std::vector<bool> seen_face_, seen_edge_;
  std::vector<Place> walked_;
  std::vector<Halfedge> order_;
};

}  // namespace

std::vector<Halfedge> grid_order(const Mesh& mesh, std::uint64_t seed) {
  return GridWalk(mesh, seed, false).run();
}

std::vector<Halfedge> dual_grid_order(const Mesh& mesh, std::uint64_t seed) {
  return GridWalk(mesh, seed, true).run();
}

}  // namespace gradmesh
