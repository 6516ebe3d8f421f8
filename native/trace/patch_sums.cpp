#include "trace/patch_sums.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/patch_sums.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef GRADMESH_TRACE_PATCH_SUMS_ONCE
#define GRADMESH_TRACE_PATCH_SUMS_ONCE
namespace gradmesh {

/// How many pixels are worked on at a time, so that what is found of them stays in the nearest
/// cache; and of how many sums each sum is made.
constexpr std::size_t block_pixels = 128, lanes_of_sums = 8;

template <std::size_t rows>
using Rows = double[rows][block_pixels];

/// The pixels of a block: their places, what they are to be, and how much they count.
struct PixelBlock {
  alignas(64) Rows<2> place;
  alignas(64) Rows<PatchSums::channels> wanted;
  alignas(64) double weight[block_pixels];
};

/// What is found of the pixels of a block.
struct BlockTerms {
  alignas(64) Rows<PatchSums::corners> corners;
  alignas(64) Rows<PatchSums::pairs> pairs;
  /// What is summed by itself, by corners and by pairs.
  alignas(64) Rows<PatchSums::channels> squares;
  alignas(64) Rows<PatchSums::channels + PatchSums::axes> by_corners;
  alignas(64) Rows<5 + PatchSums::axes * PatchSums::channels> by_pairs;
};

/// The numbers of these rows. That of opacity is summed only where the target is not opaque.
constexpr std::size_t color_row = 0, first_slope_row = 1, first_both_row = 4, opacity_row = 12;

/// A patch as bilinear maps: start + u * along_u + v * along_v + u * v * both.
struct BilinearPatch {
  struct Map {
    double start, along_u, along_v, both;
  };
  Map place[PatchSums::axes], color[PatchSums::channels];
  /// The cross products of which the inverse of the map of places is made.
  double square, linear;
};

}  // namespace gradmesh
#endif

HWY_BEFORE_NAMESPACE();
namespace gradmesh::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, lanes_of_sums>;
using V = hn::Vec<D>;
constexpr D d;

HWY_INLINE V number(double value) { return hn::Set(d, value); }

HWY_INLINE V sum_of_products(V a, V b, V c, V e) { return hn::Add(hn::Mul(a, b), hn::Mul(c, e)); }

HWY_INLINE V cross(V ax, V ay, V bx, V by) { return hn::Sub(hn::Mul(ax, by), hn::Mul(ay, bx)); }

HWY_INLINE V by_u(const BilinearPatch::Map& map, V v) {
  return hn::Add(number(map.along_u), hn::Mul(v, number(map.both)));
}

HWY_INLINE V by_v(const BilinearPatch::Map& map, V u) {
  return hn::Add(number(map.along_v), hn::Mul(u, number(map.both)));
}

HWY_INLINE V within_0_and_1(V x) { return hn::Min(hn::Max(x, hn::Zero(d)), number(1)); }

/// Finds u and v of a place in the patch: of the two places of which the map makes it, the one in
/// the patch. From r = v * V + u * (U + v * B) follows, as the last term has no cross product with
/// its own direction, (V x B) v^2 + (V x U - r x B) v - r x U = 0.
HWY_INLINE void find_parameters(const BilinearPatch& patch, V x, V y, V& u, V& v) {
  const auto& [px, py] = patch.place;
  const V rx = hn::Sub(x, number(px.start)), ry = hn::Sub(y, number(py.start));
  const V at = cross(rx, ry, number(px.along_u), number(py.along_u));
  const V slope = hn::Sub(number(patch.linear), cross(rx, ry, number(px.both), number(py.both)));
  const V root = sum_of_products(slope, slope, number(4 * patch.square), at);
  const V below = hn::Add(slope, hn::Sqrt(hn::Max(root, hn::Zero(d))));
  const auto is_degenerate = hn::Eq(below, hn::Zero(d));
  const V safe = hn::IfThenElse(is_degenerate, number(1), below);
  const V found = hn::Div(hn::Add(at, at), safe);
  v = within_0_and_1(hn::IfThenElse(is_degenerate, number(0.5), found));
  const V way_x = by_u(px, v), way_y = by_u(py, v);
  const auto is_flatter = hn::Gt(hn::Abs(way_x), hn::Abs(way_y));
  const V rest = hn::IfThenElse(is_flatter, hn::Sub(rx, hn::Mul(v, number(px.along_v))),
                                hn::Sub(ry, hn::Mul(v, number(py.along_v))));
  const V way = hn::IfThenElse(is_flatter, way_x, way_y);
  const V quotient = hn::Div(rest, way);
  u = within_0_and_1(hn::IfThenElse(hn::IsFinite(quotient), quotient, number(0.5)));
}

/// Writes how much the corners count.
HWY_INLINE void find_corners(V u, V v, std::size_t i, BlockTerms& terms) {
  const V other_u = hn::Sub(number(1), u), other_v = hn::Sub(number(1), v);
  hn::Store(hn::Mul(other_u, other_v), d, terms.corners[0] + i);
  hn::Store(hn::Mul(other_u, v), d, terms.corners[1] + i);
  hn::Store(hn::Mul(u, v), d, terms.corners[2] + i);
  hn::Store(hn::Mul(u, other_v), d, terms.corners[3] + i);
}

HWY_INLINE void find_pairs(std::size_t i, BlockTerms& terms) {
  std::size_t pair = 0;
  for (std::size_t a = 0; a < PatchSums::corners; ++a)
    for (std::size_t b = 0; b <= a; ++b, ++pair)
      hn::Store(hn::Mul(hn::Load(d, terms.corners[a] + i), hn::Load(d, terms.corners[b] + i)), d,
                terms.pairs[pair] + i);
}

/// Finds the terms of some pixels. A colour counts by the square of the target's opacity, too.
HWY_INLINE void find_terms(const BilinearPatch& patch, const PixelBlock& pixels, std::size_t i,
                           int channels, Asked asked, BlockTerms& terms) {
  const auto& [px, py] = patch.place;
  V u, v;
  find_parameters(patch, hn::Load(d, pixels.place[0] + i), hn::Load(d, pixels.place[1] + i), u, v);
  const V weight = hn::Load(d, pixels.weight + i);
  const V alpha = hn::Div(hn::Load(d, pixels.wanted[3] + i), number(255));
  const V of_color = hn::Mul(weight, hn::Mul(alpha, alpha));
  const V along_u_x = by_u(px, v), along_u_y = by_u(py, v);
  const V along_v_x = by_v(px, u), along_v_y = by_v(py, u);
  const V size = cross(along_v_x, along_v_y, along_u_x, along_u_y);
  const auto has_size = hn::Gt(size, number(1e-9));
  const V share =
      hn::IfThenElseZero(has_size, hn::Div(number(1), hn::IfThenElse(has_size, size, number(1))));
  V xx = hn::Zero(d), xy = xx, yy = xx, pull_x = xx, pull_y = xx;
  for (int k = 0; k < channels; ++k) {
    const BilinearPatch::Map& color = patch.color[k];
    const V along_u = by_u(color, v), along_v = by_v(color, u);
    const V level =
        hn::Add(number(color.start), sum_of_products(u, along_u, v, number(color.along_v)));
    const V difference = hn::Sub(level, hn::Load(d, pixels.wanted[k] + i));
    const V counts = k == 3 ? weight : of_color;
    const V weighted = hn::Mul(counts, difference);
    hn::Store(hn::Mul(weighted, difference), d, terms.squares[k] + i);
    hn::Store(hn::Neg(weighted), d, terms.by_corners[k] + i);
    if (asked != Asked::all) continue;
    const V x = hn::Mul(share, cross(along_v, along_u, along_v_y, along_u_y));
    const V y = hn::Mul(share, cross(along_u, along_v, along_u_x, along_v_x));
    const V weighted_x = hn::Mul(counts, x), weighted_y = hn::Mul(counts, y);
    xx = hn::Add(xx, hn::Mul(weighted_x, x));
    xy = hn::Add(xy, hn::Mul(weighted_x, y));
    yy = hn::Add(yy, hn::Mul(weighted_y, y));
    pull_x = hn::Add(pull_x, hn::Mul(difference, weighted_x));
    pull_y = hn::Add(pull_y, hn::Mul(difference, weighted_y));
    hn::Store(hn::Neg(weighted_x), d, terms.by_pairs[first_both_row + std::size_t(2 * k)] + i);
    hn::Store(hn::Neg(weighted_y), d, terms.by_pairs[first_both_row + std::size_t(2 * k + 1)] + i);
  }
  if (asked == Asked::squares) return;
  find_corners(u, v, i, terms);
  find_pairs(i, terms);
  hn::Store(of_color, d, terms.by_pairs[color_row] + i);
  hn::Store(weight, d, terms.by_pairs[opacity_row] + i);
  if (asked == Asked::colors) return;
  hn::Store(pull_x, d, terms.by_corners[channels] + i);
  hn::Store(pull_y, d, terms.by_corners[channels + 1] + i);
  hn::Store(xx, d, terms.by_pairs[first_slope_row] + i);
  hn::Store(xy, d, terms.by_pairs[first_slope_row + 1] + i);
  hn::Store(yy, d, terms.by_pairs[first_slope_row + 2] + i);
}

void find_all_terms(const BilinearPatch& patch, const PixelBlock& pixels, std::size_t count,
                    int channels, Asked asked, BlockTerms& terms) {
  for (std::size_t i = 0; i < count; i += hn::Lanes(d))
    find_terms(patch, pixels, i, channels, asked, terms);
}

/// Adds to the sums of some rows those of their products with `by`.
template <int rows>
HWY_INLINE void add_products(const double (*row)[block_pixels], const double* by, std::size_t count,
                             double (*sums)[lanes_of_sums]) {
  for (std::size_t lane = 0; lane < lanes_of_sums; lane += hn::Lanes(d)) {
    V sum[rows];
    for (int k = 0; k < rows; ++k) sum[k] = hn::Load(d, sums[k] + lane);
    for (std::size_t i = lane; i < count; i += lanes_of_sums) {
      const V factor = hn::Load(d, by + i);
      for (int k = 0; k < rows; ++k)
        sum[k] = hn::Add(sum[k], hn::Mul(hn::Load(d, row[k] + i), factor));
    }
    for (int k = 0; k < rows; ++k) hn::Store(sum[k], d, sums[k] + lane);
  }
}

void add_all_products(const double (*row)[block_pixels], std::size_t rows, const double* by,
                      std::size_t count, double (*sums)[lanes_of_sums]) {
  std::size_t k = 0;
  for (; k + 5 <= rows; k += 5) add_products<5>(row + k, by, count, sums + k);
  for (; k + 2 <= rows; k += 2) add_products<2>(row + k, by, count, sums + k);
  for (; k < rows; ++k) add_products<1>(row + k, by, count, sums + k);
}

}  // namespace
}  // namespace gradmesh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "base/per_thread.h"
#include "geom/cross.h"

namespace gradmesh {
namespace {

HWY_EXPORT(find_all_terms);
HWY_EXPORT(add_all_products);

template <std::size_t rows>
using LaneSums = double[rows][lanes_of_sums];

/// What a thread keeps from one patch to the next.
struct Scratch {
  PixelBlock pixels;
  BlockTerms terms;
  alignas(64) LaneSums<PatchSums::channels> squares;
  alignas(64) LaneSums<PatchSums::channels + PatchSums::axes> by_corners[PatchSums::corners];
  alignas(64) LaneSums<opacity_row + 1> by_pairs[PatchSums::pairs];
  alignas(64) double ones[block_pixels];

  Scratch() { std::ranges::fill(ones, 1.0); }
};

BilinearPatch::Map map_of(double c0, double c1, double c2, double c3) {
  return {c0, c3 - c0, c1 - c0, c0 - c1 + c2 - c3};
}

BilinearPatch bilinear(const ColoredQuad& patch) {
  const auto& [p, c] = patch;
  BilinearPatch maps{};
  for (int axis = 0; axis < 2; ++axis)
    maps.place[axis] = map_of(p[0][axis], p[1][axis], p[2][axis], p[3][axis]);
  for (int k = 0; k < 4; ++k) maps.color[k] = map_of(c[0][k], c[1][k], c[2][k], c[3][k]);
  const glm::dvec2 both = p[0] - p[1] + p[2] - p[3];
  maps.square = cross(p[1] - p[0], both);
  maps.linear = cross(p[1] - p[0], p[3] - p[0]);
  return maps;
}

double sum_of(const double (&lanes)[lanes_of_sums]) {
  static_assert(lanes_of_sums == 8);
  return ((lanes[0] + lanes[1]) + (lanes[2] + lanes[3])) +
         ((lanes[4] + lanes[5]) + (lanes[6] + lanes[7]));
}

/// Adds the pixels of a patch up, a block at a time.
class PatchSummation {
 public:
  PatchSummation(const ColoredQuad& patch, const TargetPicture& target, Asked asked)
      : maps_(bilinear(patch)),
        channels_(target.is_opaque ? 3 : 4),
        asked_(asked),
        scratch_(per_thread<Scratch>()) {
    std::fill_n(&scratch_.squares[0][0], sizeof scratch_.squares / sizeof(double), 0.0);
    std::fill_n(&scratch_.by_corners[0][0][0], sizeof scratch_.by_corners / sizeof(double), 0.0);
    std::fill_n(&scratch_.by_pairs[0][0][0], sizeof scratch_.by_pairs / sizeof(double), 0.0);
    for_each_pixel(patch.places, target.width, target.height, target.point, [&](int x, int y) {
      const double weight = target.weight(x, y);
      if (weight == 0) return;
      add(x + target.point, y + target.point, target.at(x, y), weight);
    });
    add_block();
  }

  PatchSums sums() const {
    PatchSums sums;
    const auto count = std::size_t(channels_);
    for (std::size_t k = 0; k < count; ++k) sums.squares[k] = sum_of(scratch_.squares[k]);
    if (asked_ == Asked::squares) return sums;
    for (std::size_t a = 0; a < PatchSums::corners; ++a) {
      for (std::size_t k = 0; k < count; ++k)
        sums.color_rhs[k][a] = sum_of(scratch_.by_corners[a][k]);
      for (std::size_t axis = 0; axis < PatchSums::axes; ++axis)
        sums.place_rhs[axis][a] = sum_of(scratch_.by_corners[a][count + axis]);
    }
    for (std::size_t pair = 0; pair < PatchSums::pairs; ++pair) {
      const auto& rows = scratch_.by_pairs[pair];
      sums.color[pair] = sum_of(rows[color_row]);
      sums.opacity[pair] = sum_of(rows[opacity_row]);
      for (std::size_t n = 0; n < 3; ++n) sums.place[n][pair] = sum_of(rows[first_slope_row + n]);
      for (std::size_t k = 0; k < count; ++k)
        for (std::size_t axis = 0; axis < PatchSums::axes; ++axis)
          sums.both[k][axis][pair] = sum_of(rows[first_both_row + 2 * k + axis]);
    }
    return sums;
  }

 private:
  void add(double x, double y, const glm::vec4& wanted, double weight) {
    PixelBlock& pixels = scratch_.pixels;
    pixels.place[0][count_] = x;
    pixels.place[1][count_] = y;
    for (int k = 0; k < 4; ++k) pixels.wanted[k][count_] = double(wanted[k]);
    pixels.weight[count_] = weight;
    if (++count_ == block_pixels) add_block();
  }

  void add_block() {
    if (count_ == 0) return;
    // Lanes that are left over have a pixel that does not count.
    for (const std::size_t last = count_ - 1; count_ % lanes_of_sums != 0; ++count_) {
      for (auto& row : scratch_.pixels.place) row[count_] = row[last];
      for (auto& row : scratch_.pixels.wanted) row[count_] = row[last];
      scratch_.pixels.weight[count_] = 0;
    }
    BlockTerms& terms = scratch_.terms;
    const auto channels = std::size_t(channels_);
    const auto add_products = HWY_DYNAMIC_DISPATCH(add_all_products);
    HWY_DYNAMIC_DISPATCH(find_all_terms)
    (maps_, scratch_.pixels, count_, channels_, asked_, terms);
    add_products(terms.squares, channels, scratch_.ones, count_, scratch_.squares);
    if (asked_ != Asked::squares) {
      const bool all = asked_ == Asked::all;
      for (std::size_t a = 0; a < PatchSums::corners; ++a)
        add_products(terms.by_corners, channels + (all ? PatchSums::axes : 0), terms.corners[a],
                     count_, scratch_.by_corners[a]);
      for (std::size_t pair = 0; pair < PatchSums::pairs; ++pair) {
        add_products(terms.by_pairs, all ? first_both_row + 2 * channels : 1, terms.pairs[pair],
                     count_, scratch_.by_pairs[pair]);
        if (channels == 4)
          add_products(terms.by_pairs + opacity_row, 1, terms.pairs[pair], count_,
                       scratch_.by_pairs[pair] + opacity_row);
      }
    }
    count_ = 0;
  }

  const BilinearPatch maps_;
  const int channels_;
  const Asked asked_;
  Scratch& scratch_;
  /// The pixels of the block so far.
  std::size_t count_ = 0;
};

}  // namespace

PatchSums patch_sums(const ColoredQuad& patch, const TargetPicture& target, Asked asked) {
  return PatchSummation(patch, target, asked).sums();
}

}  // namespace gradmesh
#endif  // HWY_ONCE
