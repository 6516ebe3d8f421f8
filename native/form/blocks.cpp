#include "form/blocks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <queue>
#include <set>
#include <utility>

#include "form/block_outline.h"
#include "form/written_patch.h"

namespace gradmesh {
namespace {

using Cell = Block::Cell;

bool same_as_written(const glm::dvec4& a, const glm::dvec4& b) {
  for (int i = 0; i < 4; ++i)
    if (std::round(255 * a[i]) != std::round(255 * b[i])) return false;
  return true;
}

/// The order in which faces must be painted, and which faces may therefore form a block.
class PaintOrder {
 public:
  PaintOrder(const Mesh& mesh, const std::vector<Overlap>& overlaps)
      : mesh_(mesh),
        free_(overlaps.empty()),
        above_(mesh.face_slots()),
        block_(mesh.face_slots(), -1),
        place_(mesh.face_slots(), -1) {
    for (const Overlap& overlap : overlaps) above_[overlap.below.value].push_back(overlap.above);
  }

  /// Returns true if every order is as good.
  bool is_free() const { return free_; }

  /// Returns true if these faces may be a block: they lie over one another only in the order of the
  /// cells, and nothing lies both over one and below another of them.
  bool allows(const std::vector<Cell>& cells) {
    if (free_) return true;
    for (std::size_t i = 0; i < cells.size(); ++i) place_[cells[i].face.value] = int(i);
    const bool allowed = keeps_order(cells) && !is_crossed(cells);
    for (const Cell& cell : cells) place_[cell.face.value] = -1;
    return allowed;
  }

  void take(const std::vector<Cell>& cells) {
    for (const Cell& cell : cells) block_[cell.face.value] = int(blocks_.size());
    blocks_.push_back(cells);
  }

  /// Returns the blocks, which are those given to take(), in the order of painting: each after
  /// those below it, and where that leaves a choice the one of the largest area first.
  std::vector<Block> sorted(std::vector<Block> blocks) const {
    std::vector<std::set<int>> above(blocks.size());
    std::vector<int> below(blocks.size(), 0);
    for (std::size_t i = 0; i < blocks.size(); ++i)
      for (const Cell& cell : blocks[i].cells)
        for (const Face f : above_[cell.face.value])
          if (const int j = block_[f.value]; j != int(i) && above[i].insert(j).second)
            ++below[std::size_t(j)];
    std::set<std::pair<double, int>> ready;
    const auto add = [&](int i) {
      const Block& block = blocks[std::size_t(i)];
      ready.emplace(-std::abs(doubled_area(block_outline(mesh_, block, 8))), i);
    };
    for (std::size_t i = 0; i < blocks.size(); ++i)
      if (below[i] == 0) add(int(i));
    std::vector<Block> result;
    while (!ready.empty()) {
      const auto i = std::size_t(ready.begin()->second);
      ready.erase(ready.begin());
      for (const int j : above[i])
        if (--below[std::size_t(j)] == 0) add(j);
      result.push_back(std::move(blocks[i]));
    }
    return result;
  }

 private:
  bool keeps_order(const std::vector<Cell>& cells) const {
    for (std::size_t i = 0; i < cells.size(); ++i)
      for (const Face f : above_[cells[i].face.value])
        if (place_[f.value] >= 0 && place_[f.value] < int(i)) return false;
    return true;
  }

  /// Returns true if a way upwards from one of the faces leads through others back to one of them.
  bool is_crossed(const std::vector<Cell>& cells) const {
    std::vector<Face> open;
    std::set<Face> met;
    const auto meet = [&](Face f) {
      if (place_[f.value] < 0 && met.insert(f).second) open.push_back(f);
    };
    for (const Cell& cell : cells)
      for (const Face f : above_[cell.face.value]) meet(f);
    while (!open.empty()) {
      const Face face = open.back();
      open.pop_back();
      if (const int block = block_[face.value]; block >= 0)
        for (const Cell& cell : blocks_[std::size_t(block)]) meet(cell.face);
      for (const Face f : above_[face.value]) {
        if (place_[f.value] >= 0) return true;
        meet(f);
      }
    }
    return false;
  }

  const Mesh& mesh_;
  const bool free_;
  /// For each face, the faces directly over it.
  std::vector<std::vector<Face>> above_;
  /// The block of each face, or -1, and the cells of those blocks.
  std::vector<int> block_;
  std::vector<std::vector<Cell>> blocks_;
  /// The place of each face among the cells in question; -1 for other faces.
  std::vector<int> place_;
};

class BlockFinder {
 public:
  BlockFinder(const Mesh& mesh, PaintOrder& order)
      : mesh_(mesh),
        order_(order),
        used_(mesh.face_slots(), false),
        taken_in_(mesh.face_slots(), 0) {}

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
      if (!whole || !order_.allows(candidate.block.cells)) {
        queue.push({largest_from(candidate.seed), candidate.seed});
        continue;
      }
      for (const Cell& c : candidate.block.cells) used_[c.face.value] = true;
      order_.take(candidate.block.cells);
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

  /// Returns the cell across side `side` if the surface goes on there without a T-junction or a
  /// step in colour and the cell is free.
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

  /// Returns the largest rectangle with this cell in its top left corner.
  Block largest_from(const Cell& seed) {
    std::vector<std::vector<Cell>> rows;
    ++search_;
    std::size_t width = mesh_.face_slots(), best_rows = 0, best_width = 0;
    for (std::optional<Cell> first = seed; first; first = across(rows.back().front(), 2)) {
      std::vector<Cell> row = row_from(*first, rows.empty() ? nullptr : &rows.back(), width);
      if (row.empty()) break;
      width = row.size();
      rows.push_back(std::move(row));
      for (std::size_t w = width; rows.size() * w > best_rows * best_width; --w)
        if (order_.is_free() || order_.allows(rectangle(rows, rows.size(), w).cells)) {
          best_rows = rows.size();
          best_width = w;
        }
    }
    return rectangle(rows, best_rows, best_width);
  }

  static Block rectangle(const std::vector<std::vector<Cell>>& cells, std::size_t rows,
                         std::size_t columns) {
    Block block{int(rows), int(columns), {}};
    for (std::size_t i = 0; i < rows; ++i)
      block.cells.insert(block.cells.end(), cells[i].begin(),
                         cells[i].begin() + std::ptrdiff_t(columns));
    return block;
  }

  /// Returns the cells from `first` to the right, each below the one of the row above, at most
  /// `width`.
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
  PaintOrder& order_;
  std::vector<bool> used_;
  /// For each face, the last search that has met it.
  std::vector<int> taken_in_;
  int search_ = 0;
};

bool is_opaque(double opacity) { return std::round(255 * opacity) == 255; }

/// Returns true if the side of a patch is opaque from end to end, or fully transparent.
bool is_clear_cut(const Mesh& mesh, Halfedge side) {
  const double a = mesh[side].color.a, b = mesh[mesh.next(side)].color.a;
  return (is_opaque(a) && is_opaque(b)) || std::round(255 * (a + b)) == 0;
}

bool is_opaque(const Mesh& mesh, Face face) {
  return std::ranges::all_of(mesh.sides(face),
                             [&](Halfedge h) { return is_opaque(mesh[h].color.a); });
}

/// Returns true if two blocks would both be seen at some place, since what they paint there is not
/// opaque.
bool needs_mask(const Mesh& mesh, const std::vector<Block>& blocks,
                const std::vector<Overlap>& overlaps) {
  if (!is_translucent(mesh)) return false;
  std::vector<std::size_t> block_of(mesh.face_slots());
  for (std::size_t i = 0; i < blocks.size(); ++i)
    for (const Cell& cell : blocks[i].cells) block_of[cell.face.value] = i;
  const auto apart = [&](Face a, Face b) { return block_of[a.value] != block_of[b.value]; };
  for (const Overlap& overlap : overlaps)
    if (apart(overlap.below, overlap.above) && !is_opaque(mesh, overlap.above)) return true;
  for (const Halfedge h : mesh.halfedges()) {
    if (!mesh.is_leaf(h) || is_clear_cut(mesh, h)) continue;
    const Halfedge other = mesh.other_side(h);
    // The faces beyond a T-junction are not known without a search: they count as another block's.
    if (!other.valid()) continue;
    if (mesh.is_bar(h) || mesh.is_parent(other) || apart(mesh.face(h), mesh.face(other)))
      return true;
  }
  return false;
}

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

BlockForm block_form(const Mesh& mesh, double coons_tolerance,
                     const std::vector<Overlap>& overlaps) {
  PaintOrder order(mesh, overlaps);
  BlockForm form;
  form.blocks = order.sorted(BlockFinder(mesh, order).run());
  form.coons_tolerance = coons_tolerance;
  form.masks_opacity = needs_mask(mesh, form.blocks, overlaps);
  return form;
}

MeshParts block_parts(const Mesh& mesh, const BlockForm& form) {
  MeshParts parts;
  parts.color_model = ColorModel::bilinear;
  std::map<Halfedge, int> numbers;
  for (const Block& block : form.blocks)
    for (const Cell& cell : block.cells) {
      for (int side = 0; side < 4; ++side)
        numbers[block_side(mesh, cell, side)] = 4 * int(parts.patches.size()) + side;
      parts.patches.push_back(
          as_written(block_patch(mesh, cell), form.coons_tolerance, form.masks_opacity));
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
