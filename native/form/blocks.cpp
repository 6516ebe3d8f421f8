#include "form/blocks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <queue>
#include <set>
#include <utility>

#include "form/block_outline.h"
#include "form/handles.h"
#include "form/rounding.h"

namespace gradmesh {
namespace {

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

  /// Returns true if the patches with these tops may be a block: they lie over one another only in
  /// the order of the tops, and nothing lies both over one and below another of them.
  bool allows(const std::vector<Halfedge>& tops) {
    if (free_) return true;
    for (std::size_t i = 0; i < tops.size(); ++i) place_[mesh_.face(tops[i]).value] = int(i);
    const bool allowed = keeps_order(tops) && !is_crossed(tops);
    for (const Halfedge top : tops) place_[mesh_.face(top).value] = -1;
    return allowed;
  }

  void take(const std::vector<Halfedge>& tops) {
    for (const Halfedge top : tops) block_[mesh_.face(top).value] = int(blocks_.size());
    blocks_.push_back(tops);
  }

  /// Returns the blocks, which are those given to take(), in the order of painting: each after
  /// those below it, and where that leaves a choice the one of the largest area first.
  std::vector<Rectangle> sorted(std::vector<Rectangle> blocks) const {
    std::vector<std::set<int>> above(blocks.size());
    std::vector<int> below(blocks.size(), 0);
    for (std::size_t i = 0; i < blocks.size(); ++i)
      for (const Halfedge top : blocks[i].tops)
        for (const Face f : above_[mesh_.face(top).value])
          if (const int j = block_[f.value]; j != int(i) && above[i].insert(j).second)
            ++below[std::size_t(j)];
    std::set<std::pair<double, int>> ready;
    const auto add = [&](int i) {
      const Rectangle& block = blocks[std::size_t(i)];
      ready.emplace(-std::abs(doubled_area(block_outline(mesh_, block, 8))), i);
    };
    for (std::size_t i = 0; i < blocks.size(); ++i)
      if (below[i] == 0) add(int(i));
    std::vector<Rectangle> result;
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
  bool keeps_order(const std::vector<Halfedge>& tops) const {
    for (std::size_t i = 0; i < tops.size(); ++i)
      for (const Face f : above_[mesh_.face(tops[i]).value])
        if (place_[f.value] >= 0 && place_[f.value] < int(i)) return false;
    return true;
  }

  /// Returns true if a way upwards from one of the faces leads through others back to one of them.
  bool is_crossed(const std::vector<Halfedge>& tops) const {
    std::vector<Face> open;
    std::set<Face> met;
    const auto meet = [&](Face f) {
      if (place_[f.value] < 0 && met.insert(f).second) open.push_back(f);
    };
    for (const Halfedge top : tops)
      for (const Face f : above_[mesh_.face(top).value]) meet(f);
    while (!open.empty()) {
      const Face face = open.back();
      open.pop_back();
      if (const int block = block_[face.value]; block >= 0)
        for (const Halfedge top : blocks_[std::size_t(block)]) meet(mesh_.face(top));
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
  /// The block of each face, or -1, and the tops of those blocks.
  std::vector<int> block_;
  std::vector<std::vector<Halfedge>> blocks_;
  /// The place of each face among those in question; -1 for other faces.
  std::vector<int> place_;
};

class BlockFinder {
 public:
  BlockFinder(const Mesh& mesh, PaintOrder& order)
      : mesh_(mesh),
        order_(order),
        used_(mesh.face_slots(), false),
        taken_in_(mesh.face_slots(), 0),
        widths_(mesh.halfedge_slots(), 0) {}

  std::vector<Rectangle> run() {
    // A rectangle can only shrink as others take its faces, so the first that is still whole when
    // its turn comes is the largest there is. It is searched for only where it may be that one.
    std::priority_queue<Candidate> queue;
    for (const Face f : mesh_.faces())
      for (int top = 0; top < 4; ++top) queue.push(promise(f, top));
    std::vector<Rectangle> blocks;
    while (!queue.empty()) {
      const Candidate best = queue.top();
      queue.pop();
      if (used_[best.face.value]) continue;
      if (best.block.tops.empty()) {
        queue.push(candidate(best.face, best.top));
        continue;
      }
      const bool whole = std::ranges::none_of(
          best.block.tops, [&](Halfedge top) { return used_[mesh_.face(top).value]; });
      if (!whole || !order_.allows(best.block.tops)) {
        queue.push(promise(best.face, best.top));
        continue;
      }
      for (const Halfedge top : best.block.tops) used_[mesh_.face(top).value] = true;
      order_.take(best.block.tops);
      blocks.push_back(best.block);
    }
    return blocks;
  }

 private:
  struct Candidate {
    /// Without tops until it has been searched for.
    Rectangle block;
    /// The face with which the block begins, and which of its sides is the top there.
    Face face;
    int top;
    /// The number of its patches, or at least as many.
    std::size_t size;

    bool operator<(const Candidate& o) const {
      if (size != o.size) return size < o.size;
      return std::pair(top, face) > std::pair(o.top, o.face);
    }
  };

  Candidate candidate(Face face, int top) {
    Rectangle block = largest_from(mesh_.sides(face)[std::size_t(top)]);
    const std::size_t size = block.tops.size();
    return {std::move(block), face, top, size};
  }

  /// Returns a candidate that has not been searched for, of the size that the lengths of rows
  /// allow.
  Candidate promise(Face face, int top) {
    const Halfedge seed = mesh_.sides(face)[std::size_t(top)];
    std::size_t rows = 0, width = mesh_.face_slots(), size = 0;
    for (std::optional<Halfedge> first = seed; first && rows < mesh_.face_slots();
         first = across(*first, 2)) {
      width = std::min(width, width_from(*first));
      size = std::max(size, ++rows * width);
      if (across(*first, 2) == seed) break;
    }
    return {{}, face, top, size};
  }

  /// Returns how many patches at most lie side by side from this top to the right, which only
  /// becomes less.
  std::size_t width_from(Halfedge top) {
    std::vector<Halfedge> row;
    std::optional<Halfedge> at = top;
    for (; at && widths_[at->value] == 0; at = across(*at, 1)) {
      if (!row.empty() && *at == top) break;
      row.push_back(*at);
    }
    const bool is_ring = at == top && !row.empty();
    std::size_t width = is_ring ? row.size() : at ? widths_[at->value] : 0;
    while (!row.empty()) {
      width = is_ring ? width : width + 1;
      widths_[row.back().value] = width;
      row.pop_back();
    }
    return widths_[top.value];
  }

  /// Returns the top of the patch across side `side` of the patch with this top, if the surface
  /// goes on there without a T-junction or a step in colour and no block has taken that patch.
  std::optional<Halfedge> across(Halfedge top, int side) const {
    const Halfedge h = mesh_.sides(top)[side];
    if (mesh_.is_bar(h)) return std::nullopt;
    const Halfedge twin = mesh_[h].twin;
    if (!twin.valid() || mesh_.is_parent(twin)) return std::nullopt;
    if (used_[mesh_.face(twin).value]) return std::nullopt;
    if (!same_as_written(mesh_[h].color, mesh_[mesh_.next(twin)].color) ||
        !same_as_written(mesh_[twin].color, mesh_[mesh_.next(h)].color))
      return std::nullopt;
    // In the block the twin is the side opposite to `side`.
    return mesh_.sides(twin)[(6 - side) % 4];
  }

  /// Returns the largest rectangle whose first patch has this top.
  Rectangle largest_from(Halfedge seed) {
    std::vector<std::vector<Halfedge>> rows;
    ++search_;
    std::size_t width = mesh_.face_slots(), best_rows = 0, best_width = 0;
    for (std::optional<Halfedge> first = seed; first; first = across(rows.back().front(), 2)) {
      std::vector<Halfedge> row = row_from(*first, rows.empty() ? nullptr : &rows.back(), width);
      if (row.empty()) break;
      width = row.size();
      rows.push_back(std::move(row));
      for (std::size_t w = width; rows.size() * w > best_rows * best_width; --w)
        if (order_.is_free() || order_.allows(rectangle(rows, rows.size(), w).tops)) {
          best_rows = rows.size();
          best_width = w;
        }
    }
    return rectangle(rows, best_rows, best_width);
  }

  static Rectangle rectangle(const std::vector<std::vector<Halfedge>>& tops, std::size_t rows,
                             std::size_t columns) {
    Rectangle block{int(rows), int(columns), {}};
    for (std::size_t i = 0; i < rows; ++i)
      block.tops.insert(block.tops.end(), tops[i].begin(),
                        tops[i].begin() + std::ptrdiff_t(columns));
    return block;
  }

  /// Returns the tops from `first` to the right, each below the one of the row above, at most
  /// `width`.
  std::vector<Halfedge> row_from(Halfedge first, const std::vector<Halfedge>* above,
                                 std::size_t width) {
    std::vector<Halfedge> row;
    for (std::optional<Halfedge> top = first; top && row.size() < width;
         top = across(row.back(), 1)) {
      if (above && across((*above)[row.size()], 2) != top) break;
      if (std::exchange(taken_in_[mesh_.face(*top).value], search_) == search_) break;
      row.push_back(*top);
    }
    return row;
  }

  const Mesh& mesh_;
  PaintOrder& order_;
  std::vector<bool> used_;
  /// For each face, the last search that has met it.
  std::vector<int> taken_in_;
  /// For each top, how wide the row from it was when that was asked for, or 0.
  std::vector<std::size_t> widths_;
  int search_ = 0;
};

/// Returns true if the side of a patch is one of a patch that must stay as it is.
bool is_beside_fixed(const Mesh& mesh, Halfedge side) {
  if (mesh.is_fixed(mesh.face(side))) return true;
  const Halfedge other = mesh.other_side(side);
  return other.valid() && std::ranges::any_of(mesh.leaves(other), [&](Halfedge leaf) {
           return mesh.is_fixed(mesh.face(leaf));
         });
}

/// Returns the coordinates with which the patches that must stay as they are are written.
std::vector<double> fixed_coordinates(const Mesh& mesh, const Affine& to_written, double exact) {
  std::vector<double> coordinates;
  const auto add = [&](glm::dvec2 p) { coordinates.insert(coordinates.end(), {p.x, p.y}); };
  for (const Face f : mesh.faces()) {
    if (!mesh.is_fixed(f)) continue;
    const Patch patch = mesh.patch(f);
    for (int k = 0; k < 4; ++k) {
      const Cubic<Value> side = patch.side(k);
      add(to_written.point(side.p0.position));
      if (is_straight(side, exact)) continue;
      add(to_written.point(side.bezier1().position));
      add(to_written.point(side.bezier2().position));
    }
    if (!needs_tensor(patch, exact)) continue;
    const BezierNet net = bezier_net(patch);
    for (const int i : {1, 2})
      for (const int j : {1, 2})
        add(to_written.vector(net[i][j].position - net[i == 1 ? 0 : 3][j == 1 ? 0 : 3].position));
  }
  return coordinates;
}

/// Returns the precision with a step of which the coordinates of what must stay as it is are
/// multiples; without one if they are of none.
Precision keeping_fixed(const Mesh& mesh, Precision precision) {
  if (!mesh.has_fixed_faces()) return precision;
  precision.last_bits = last_bits_of(mesh);
  if (precision.step == 0) return precision;
  const std::vector<double> coordinates =
      fixed_coordinates(mesh, precision.to_written, precision.last_bits);
  double largest = 0;
  for (const double x : coordinates) largest = std::max(largest, std::abs(x));
  const double exact = share_of_last_bits * largest;
  const auto is_kept = [&](double step) {
    return std::ranges::all_of(
        coordinates, [&](double x) { return std::abs(x - round_to_step(x, step)) <= exact; });
  };
  // Of a step that is not much more than the last bits any number is a multiple.
  for (int decimals = int(std::lround(-std::log10(precision.step)));; ++decimals) {
    precision.step = decimal_step(power_of_ten(-decimals));
    if (precision.step < 10 * exact) precision.step = 0;
    if (precision.step == 0 || is_kept(precision.step)) return precision;
  }
}

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
bool needs_mask(const Mesh& mesh, const std::vector<Rectangle>& blocks,
                const std::vector<Overlap>& overlaps) {
  if (!is_translucent(mesh)) return false;
  std::vector<std::size_t> block_of(mesh.face_slots());
  for (std::size_t i = 0; i < blocks.size(); ++i)
    for (const Halfedge top : blocks[i].tops) block_of[mesh.face(top).value] = i;
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

BlockForm block_form(const Mesh& mesh, double coons_tolerance,
                     const std::vector<Overlap>& overlaps) {
  PaintOrder order(mesh, overlaps);
  BlockForm form;
  form.blocks = order.sorted(BlockFinder(mesh, order).run());
  constexpr double share = 0.1;
  form.precision = keeping_fixed(mesh, precision_for(coons_tolerance, share));
  form.masks_opacity = needs_mask(mesh, form.blocks, overlaps);
  return form;
}

bool has_one_color_at_each_point(const Mesh& mesh, double tolerance) {
  std::map<Point, glm::dvec4> colors;
  for (const Halfedge h : mesh.halfedges()) {
    if (!mesh.is_leaf(h)) continue;
    const glm::dvec4& color = mesh[h].color;
    const auto [known, is_new] = colors.emplace(mesh.origin(h), color);
    for (int i = 0; i < 4; ++i)
      if (std::abs(known->second[i] - color[i]) > tolerance) return false;
  }
  return true;
}

Precision gradient_precision(double coons_tolerance, const Affine& to_gradient) {
  return precision_for(coons_tolerance, 1, to_gradient);
}

BlockForm gradient_form(const Mesh& mesh, double coons_tolerance, const Affine& to_gradient) {
  return {{find_grid(mesh).value()},
          keeping_fixed(mesh, gradient_precision(coons_tolerance, to_gradient))};
}

PatchTolerance patch_tolerance(const Mesh& mesh, Halfedge top, const Precision& precision) {
  PatchTolerance tolerance = patch_tolerance(precision);
  if (precision.last_bits == 0) return tolerance;
  if (mesh.is_fixed(mesh.face(top))) tolerance.coons = precision.last_bits;
  const auto sides = mesh.sides(top);
  for (std::size_t k = 0; k < 4; ++k)
    if (is_beside_fixed(mesh, sides[k])) tolerance.straight[k] = precision.last_bits;
  return tolerance;
}

Patch written_patch(const Mesh& mesh, Halfedge top, const BlockForm& form) {
  return written_patch(mesh.patch(top), form.precision, patch_tolerance(mesh, top, form.precision),
                       form.masks_opacity);
}

MeshParts block_parts(const Mesh& mesh, const BlockForm& form) {
  MeshParts parts;
  parts.smooth = mesh.is_smooth();
  std::map<Halfedge, int> numbers;
  for (const Rectangle& block : form.blocks)
    for (const Halfedge top : block.tops) {
      for (int side = 0; side < 4; ++side)
        numbers[mesh.sides(top)[side]] = 4 * int(parts.patches.size()) + side;
      parts.patches.push_back(written_patch(mesh, top, form));
    }
  const auto side_parts = [&](Halfedge side) {
    CurveSide result;
    for (const Halfedge leaf : mesh.leaves(side)) {
      if (!result.halfedges.empty()) result.breaks.push_back(mesh[leaf].interval.first);
      result.halfedges.push_back(numbers.at(leaf));
    }
    return result;
  };
  for (const Halfedge h : mesh.curves())
    if (mesh[h].twin.valid()) parts.curves.push_back({side_parts(h), side_parts(mesh[h].twin)});
  return parts;
}

}  // namespace gradmesh
