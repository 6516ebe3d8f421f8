#include "metric/flip.h"

#include <algorithm>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "metric/flip.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "metric/elementary-inl.h"
#include "metric/filter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gradmesh::HWY_NAMESPACE {
namespace {

using D = Lanes<float>;
using V = hn::Vec<D>;
constexpr D d;

/// Returns the base-2 logarithm of the colour's part of FLIP: of the HyAB distance to the power
/// 0.7, mapped to 0..1 so that the greatest distance, green against blue, becomes 1, and distances
/// beyond 0.4 of it share the last twentieth (the paper's error redistribution).
HWY_INLINE V log2_colour(V hyab) {
  constexpr float greatest = 41.276096F, knee = 0.4F * greatest, at_knee = 0.95F;
  constexpr float log2_below = -4.11930714F;  // log2(at_knee / knee)
  constexpr float above = (1 - at_knee) / (greatest - knee);
  const V log2_distance = hn::Mul(hn::Set(d, 0.7F), log2_positive(d, hyab));
  const V log2_near = hn::Add(log2_distance, hn::Set(d, log2_below));
  const auto is_near = hn::Lt(log2_near, hn::Set(d, -0.0740005995F));  // log2(at_knee)
  if (HWY_LIKELY(hn::AllTrue(d, is_near))) return log2_near;
  const V distance = exp2_bounded(d, log2_distance);
  const V far = scaled_sum(d, above, hn::Sub(distance, hn::Set(d, knee)), at_knee);
  return hn::IfThenElse(is_near, log2_near, log2_positive(d, far));
}

HWY_INLINE V difference(const float* s, const float* t) {
  return hn::Sub(hn::LoadU(d, s), hn::LoadU(d, t));
}

/// Writes the HyAB distances of the colours, strengthened where edges or points differ as well. The
/// reference's appearance is not in the cache, so the next row's is prefetched.
void compare(AppearanceRow<const float> s, std::ptrdiff_t next_row, AppearanceRow<float> t,
             int count, float* out) {
  for (int i = 0; i < count; i += int(hn::Lanes(d))) {
    for (const float* plane : {s.lightness, s.a, s.b, s.edge, s.point})
      hwy::Prefetch(plane + next_row + i);
    const V da = difference(s.a + i, t.a + i), db = difference(s.b + i, t.b + i);
    const V hyab = hn::Add(hn::Abs(difference(s.lightness + i, t.lightness + i)),
                           hn::Sqrt(hn::Add(hn::Mul(da, da), hn::Mul(db, db))));
    const V greater = hn::Max(hn::Abs(difference(s.edge + i, t.edge + i)),
                              hn::Abs(difference(s.point + i, t.point + i)));
    const V feature = hn::Sqrt(hn::Mul(greater, hn::Set(d, 0.707106781F)));  // over sqrt(2)
    const V exponent = hn::Sub(hn::Set(d, 1.0F), feature);
    const V distance = exp2_bounded(d, hn::Mul(exponent, log2_colour(hyab)));
    hn::StoreU(hn::IfThenElseZero(hn::Gt(hyab, hn::Zero(d)), distance), d, out + i);
  }
}

}  // namespace
}  // namespace gradmesh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "base/parallel.h"
#include "base/per_thread.h"

namespace gradmesh {
namespace {

HWY_EXPORT(compare);

/// Buffers for one tile. Each thread keeps its own, as there may be hundreds of thousands of tiles.
struct Scratch {
  AppearanceFilter filter;
  PaddedRows<float> row, distance;
};

}  // namespace

Flip::Flip(Image image, Weights weights)
    : Metric(std::move(image), appearance_reach, std::move(weights)) {
  appearance_.reset(reference().window(), appearance_planes);
  for_each_strip(reference().window(), [&](Window strip) {
    AppearanceFilter& filter = per_thread<Scratch>().filter;
    filter.read(reference(), reference().window(), strip);
    for (int y = strip.y0; y < strip.y1; ++y) filter.row(y, appearance_row(appearance_, 0, y));
  });
}

void Flip::score(const Image& test, Window tile, Plane& map) const {
  Scratch& scratch = per_thread<Scratch>();
  const Window one_row = {tile.x0, 0, tile.x1, 1};
  scratch.row.reset(one_row, appearance_planes);
  scratch.distance.reset(one_row, 1);
  const AppearanceRow<float> seen = appearance_row(scratch.row, tile.x0, 0);
  float* distance = scratch.distance.row(0, 0);
  const auto compare_row = HWY_DYNAMIC_DISPATCH(compare);
  scratch.filter.read(test, reference().window(), tile);
  for (int y = tile.y0; y < tile.y1; ++y) {
    scratch.filter.row(y, seen);
    compare_row(appearance_row(appearance_, tile.x0, y), appearance_.stride(), seen, tile.width(),
                distance);
    std::copy_n(distance, tile.width(), map.at(tile.x0, y));
  }
}

}  // namespace gradmesh
#endif  // HWY_ONCE
