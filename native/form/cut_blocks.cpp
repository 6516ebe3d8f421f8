#include "form/cut_blocks.h"

#include <algorithm>
#include <cmath>

#include "mesh/build.h"
#include "mesh/subdivide.h"

namespace gradmesh {
namespace {

using Cuts = std::vector<std::vector<double>>;

/// Returns the parts into which the places cut [0, 1].
std::vector<Interval> parts_between(const std::vector<double>& places) {
  std::vector<Interval> parts{{0, 1}};
  for (const double t : places) {
    parts.back().second = t;
    parts.push_back({t, 1});
  }
  return parts;
}

/// Returns the number of rows or columns before each as it was, and of all of them.
std::vector<int> first_parts(const Cuts& places) {
  std::vector<int> first{0};
  for (const std::vector<double>& of_one : places)
    first.push_back(first.back() + int(of_one.size()) + 1);
  return first;
}

/// The sides of the patches of one block before and after it was cut.
class CutSides {
 public:
  /// The numbers of the block's first patch before and after.
  CutSides(const BlockCuts& cuts, int first_before, int first_after)
      : cuts_(cuts),
        rows_(first_parts(cuts.rows)),
        columns_(first_parts(cuts.columns)),
        first_before_(first_before),
        first_after_(first_after) {}

  int patches_before() const { return int(cuts_.rows.size() * cuts_.columns.size()); }
  int patches_after() const { return rows_.back() * columns_.back(); }

  /// Returns what a side of a patch has become, in its own direction.
  CurveSide parts(int halfedge) const {
    const int patch = halfedge / 4 - first_before_, side = halfedge % 4;
    const auto i = std::size_t(patch) / cuts_.columns.size();
    const auto j = std::size_t(patch) % cuts_.columns.size();
    const bool across = side % 2 == 0;  // Along a row.
    const int row = side == 2 ? rows_[i + 1] - 1 : rows_[i];
    const int column = side == 1 ? columns_[j + 1] - 1 : columns_[j];
    CurveSide result{{}, across ? cuts_.columns[j] : cuts_.rows[i]};
    for (int k = 0; k <= int(result.breaks.size()); ++k)
      result.halfedges.push_back(across ? number(row, column + k, side)
                                        : number(row + k, column, side));
    if (side >= 2) {
      std::ranges::reverse(result.halfedges);
      std::ranges::reverse(result.breaks);
      for (double& t : result.breaks) t = 1 - t;
    }
    return result;
  }

 private:
  int number(int row, int column, int side) const {
    return 4 * (first_after_ + row * columns_.back() + column) + side;
  }

  const BlockCuts& cuts_;
  const std::vector<int> rows_, columns_;
  const int first_before_, first_after_;
};

/// Returns the curves, which name patches as they were numbered before, with the sides of those
/// that take their places.
std::vector<CurveParts> cut_curves(std::vector<CurveParts> curves,
                                   const std::vector<BlockCuts>& cuts) {
  std::vector<CutSides> blocks;
  std::vector<int> firsts;
  int before = 0, after = 0;
  for (const BlockCuts& c : cuts) {
    firsts.push_back(before);
    const CutSides& block = blocks.emplace_back(c, before, after);
    before += block.patches_before();
    after += block.patches_after();
  }
  const auto cut_side = [&](const CurveSide& side) {
    CurveSide result;
    for (std::size_t i = 0; i < side.halfedges.size(); ++i) {
      const double low = i == 0 ? 0 : side.breaks[i - 1];
      const double high = i == side.breaks.size() ? 1 : side.breaks[i];
      const int h = side.halfedges[i];
      const auto block = std::ranges::upper_bound(firsts, h / 4) - firsts.begin() - 1;
      const CurveSide parts = blocks[std::size_t(block)].parts(h);
      if (i > 0) result.breaks.push_back(low);
      for (const double t : parts.breaks) result.breaks.push_back(std::lerp(low, high, t));
      result.halfedges.insert(result.halfedges.end(), parts.halfedges.begin(),
                              parts.halfedges.end());
    }
    return result;
  };
  for (CurveParts& curve : curves) {
    curve.a = cut_side(curve.a);
    curve.b = cut_side(curve.b);
  }
  return curves;
}

/// Returns the mesh of the blocks as they were written, cut.
MeshParts cut_parts(const std::vector<PatchGrid>& blocks, std::vector<CurveParts> curves,
                    const std::vector<BlockCuts>& cuts) {
  const Mesh before = build_mesh(parts_of(blocks, curves));
  for (CurveParts& curve : curves) {
    const Halfedge side = before.curve_side(Halfedge{curve.a.halfedges[0]});
    const auto [start, end] = before[side].handles;
    curve.tangents = {before[start].tangent, before[end].tangent};
  }
  std::vector<PatchGrid> pieces;
  for (std::size_t b = 0; b < blocks.size(); ++b) pieces.push_back(cut(blocks[b], cuts[b]));
  MeshParts parts =
      subdivided(build_mesh(parts_of(pieces, cut_curves(std::move(curves), cuts))), 1);
  // Where a patch has a curve to itself its own tangents count, which a person may have edited.
  for (CurveParts& curve : parts.curves)
    if (curve.a.breaks.empty() || curve.b.breaks.empty()) curve.tangents.reset();
  return parts;
}

}  // namespace

PatchGrid cut(const PatchGrid& block, const BlockCuts& cuts) {
  const std::vector<int> rows = first_parts(cuts.rows), columns = first_parts(cuts.columns);
  PatchGrid result{rows.back(), columns.back(), {}};
  for (std::size_t i = 0; i < cuts.rows.size(); ++i)
    for (const auto& [top, bottom] : parts_between(cuts.rows[i]))
      for (std::size_t j = 0; j < cuts.columns.size(); ++j) {
        const Patch row = block.patches[i * cuts.columns.size() + j].part_u(top, bottom);
        for (const auto& [left, right] : parts_between(cuts.columns[j]))
          result.patches.push_back(row.part_v(left, right));
      }
  return result;
}

std::vector<int> removed_patches(const EditedBlocks& blocks) {
  std::vector<int> removed;
  int next = 0;
  for (std::size_t b = 0; b < blocks.removed.size(); ++b)
    for (std::size_t i = 0; i < blocks.read[b].patches.size(); ++i, ++next)
      if (blocks.removed[b]) removed.push_back(next);
  return removed;
}

Reconciled reconcile(const EditedBlocks& blocks) {
  if (blocks.written.empty()) return reconcile(parts_of(blocks.read, blocks.curves));
  MeshParts read = parts_of(blocks.read), written = parts_of(blocks.written, blocks.curves);
  const bool is_cut = read.patches.size() > written.patches.size();
  if (is_cut) written = cut_parts(blocks.written, blocks.curves, blocks.cuts);
  read.curves = written.curves;
  Reconciled result = reconcile(read, written);
  result.edited = result.edited || is_cut;
  return result;
}

}  // namespace gradmesh
