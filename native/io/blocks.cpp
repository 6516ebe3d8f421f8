#include "io/blocks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <queue>
#include <utility>

#include "geom/written.h"
#include "io/block_outline.h"

namespace gradmesh {
namespace {

using Cell = Block::Cell;

bool same_as_written(const glm::dvec4& a, const glm::dvec4& b) {
  for (int i = 0; i < 4; ++i)
    if (std::round(255 * a[i]) != std::round(255 * b[i])) return false;
  return true;
}

class BlockFinder {
 public:
  explicit BlockFinder(const Mesh& mesh)
      : mesh_(mesh), used_(mesh.face_slots(), false), taken_in_(mesh.face_slots(), 0) {}

  std::vector<Block> run() {
    // A rectangle can only shrink as others take its faces, so the first that is still whole when
    // its turn comes is the largest there is.
    std::priority_queue<Candidate> queue;
    for (const Face f : mesh_.faces())
      for (int top = 0; top < 4; ++top) queue.push({largest_from({f, top}), {f, top}});
    std::vector<Block> blocks;
    while (!queue.empty()) {
      const Candidate candidate = queue.top();
      queue.pop();
      if (used_[candidate.seed.face.value]) continue;
      const bool whole = std::ranges::none_of(candidate.block.cells,
                                              [&](const Cell& c) { return used_[c.face.value]; });
      if (!whole) {
        queue.push({largest_from(candidate.seed), candidate.seed});
        continue;
      }
      for (const Cell& c : candidate.block.cells) used_[c.face.value] = true;
      blocks.push_back(candidate.block);
    }
    return blocks;
  }

 private:
  struct Candidate {
    Block block;
    Cell seed;

    bool operator<(const Candidate& o) const {
      const std::size_t a = block.cells.size(), b = o.block.cells.size();
      if (a != b) return a < b;
      return std::pair(seed.top, seed.face) > std::pair(o.seed.top, o.seed.face);
    }
  };

  /// The cell across side `side`, if the surface goes on there without a T-junction or a step in
  /// colour and the cell is free.
  std::optional<Cell> across(const Cell& cell, int side) const {
    const Halfedge h = block_side(mesh_, cell, side);
    if (mesh_.is_bar(h)) return std::nullopt;
    const Halfedge twin = mesh_[h].twin;
    if (!twin.valid() || mesh_.is_parent(twin)) return std::nullopt;
    const Face face = mesh_.face(twin);
    if (used_[face.value]) return std::nullopt;
    if (!same_as_written(mesh_[h].color, mesh_[mesh_.next(twin)].color) ||
        !same_as_written(mesh_[twin].color, mesh_[mesh_.next(h)].color))
      return std::nullopt;
    const auto sides = mesh_.sides(face);
    const int found = int(std::ranges::find(sides, twin) - sides.begin());
    // The twin is the opposite side in the block: found = top + side + 2, modulo 4.
    return Cell{face, (found - side + 6) % 4};
  }

  /// The largest rectangle with this cell in its top left corner.
  Block largest_from(const Cell& seed) {
    std::vector<std::vector<Cell>> rows;
    ++search_;
    std::size_t width = mesh_.face_slots(), best_rows = 0, best_width = 0;
    for (std::optional<Cell> first = seed; first; first = across(rows.back().front(), 2)) {
      std::vector<Cell> row = row_from(*first, rows.empty() ? nullptr : &rows.back(), width);
      if (row.empty()) break;
      width = row.size();
      rows.push_back(std::move(row));
      if (rows.size() * width > best_rows * best_width) {
        best_rows = rows.size();
        best_width = width;
      }
    }
    Block block{int(best_rows), int(best_width), {}};
    for (std::size_t i = 0; i < best_rows; ++i)
      block.cells.insert(block.cells.end(), rows[i].begin(), rows[i].begin() + best_width);
    return block;
  }

  /// Cells to the right of `first`, each below the one of the row above, at most `width`.
  std::vector<Cell> row_from(const Cell& first, const std::vector<Cell>* above, std::size_t width) {
    std::vector<Cell> row;
    for (std::optional<Cell> cell = first; cell && row.size() < width;
         cell = across(row.back(), 1)) {
      if (above && across((*above)[row.size()], 2) != cell) break;
      if (std::exchange(taken_in_[cell->face.value], search_) == search_) break;
      row.push_back(*cell);
    }
    return row;
  }

  const Mesh& mesh_;
  std::vector<bool> used_;
  /// The last search that has met a face.
  std::vector<int> taken_in_;
  int search_ = 0;
};

}  // namespace

Halfedge block_side(const Mesh& mesh, const Cell& cell, int side) {
  return mesh.sides(cell.face)[(cell.top + side) % 4];
}

Patch block_patch(const Mesh& mesh, const Cell& cell) {
  const Patch patch = mesh.patch(cell.face);
  if (cell.top == 0) return patch;
  std::array<Cubic<Value>, 4> sides;
  std::array<Value, 4> twists;
  for (int k = 0; k < 4; ++k) {
    sides[k] = patch.side((cell.top + k) % 4);
    twists[k] = patch.twist((cell.top + k) % 4);
  }
  return patch_from_sides(sides, twists);
}

std::vector<Block> find_blocks(const Mesh& mesh) {
  std::vector<Block> blocks = BlockFinder(mesh).run();
  std::vector<std::pair<double, std::size_t>> order;
  for (const Block& block : blocks)
    order.emplace_back(-std::abs(doubled_area(block_outline(mesh, block, 8))), order.size());
  std::ranges::sort(order);
  std::vector<Block> sorted;
  for (const auto& [area, i] : order) sorted.push_back(std::move(blocks[i]));
  return sorted;
}

std::array<std::vector<Block>, 2> possible_blocks(const Mesh& mesh) {
  const std::vector<Block> by_area = find_blocks(mesh);
  std::vector<Block> by_face = by_area;
  std::ranges::stable_sort(by_face, {}, [](const Block& block) {
    return std::ranges::min(block.cells, {}, &Cell::face).face;
  });
  return {by_area, by_face};
}

MeshParts block_parts(const Mesh& mesh, const std::vector<Block>& blocks, double coons_tolerance) {
  MeshParts parts;
  parts.color_model = ColorModel::bilinear;
  const bool masked = is_translucent(mesh);
  std::map<Halfedge, int> numbers;
  for (const Block& block : blocks)
    for (const Cell& cell : block.cells) {
      for (int side = 0; side < 4; ++side)
        numbers[block_side(mesh, cell, side)] = 4 * int(parts.patches.size()) + side;
      parts.patches.push_back(as_written(block_patch(mesh, cell), coons_tolerance, masked));
    }
  const auto side_parts = [&](Halfedge side) {
    CurveSide result;
    for (const Halfedge leaf : mesh.leaves(side)) {
      if (!result.halfedges.empty()) result.breaks.push_back(mesh[leaf].interval.first);
      result.halfedges.push_back(numbers.at(leaf));
    }
    return result;
  };
  for (const Halfedge h : mesh.halfedges())
    if (!mesh.is_bar(h) && mesh.curve(h) == h && mesh[h].twin.valid())
      parts.curves.push_back({side_parts(h), side_parts(mesh[h].twin)});
  return parts;
}

}  // namespace gradmesh
