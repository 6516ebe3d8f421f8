#include "raster/fill.h"

#include <algorithm>

#include <hwy/cache_control.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/fill.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/newton-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gradmesh::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Returns for each of these parameters whether Newton's method is to be used there.
template <class D, class V>
HWY_INLINE hn::Mask<D> is_refined(D d, const Refinement& refinement, V u, V v) {
  const hn::RebindToSigned<D> di;
  const auto cell = [&](V t) {
    const auto index = hn::ConvertTo(di, hn::Mul(t, hn::Set(d, float(Folds::cells))));
    return hn::Min(hn::Max(index, hn::Zero(di)), hn::Set(di, Folds::cells - 1));
  };
  const auto row = hn::GatherIndex(di, refinement.cells.data(), cell(u));
  return hn::RebindMask(d, hn::TestBit(row, hn::Shl(hn::Set(di, 1), cell(v))));
}

void refine(const Refinement& refinement, Parameters& parameters) {
  // Longer vectors would be filled less well.
  const hn::CappedTag<float, 8> d;
  const hn::RebindToSigned<decltype(d)> di;
  using V = hn::Vec<decltype(d)>;
  const V half = hn::Set(d, 0.5F);
  const Window window = parameters.window;
  for (int row = window.y0; row < window.y1; ++row) {
    float* u_row = parameters.u.data() + parameters.offset(window.x0, row);
    float* v_row = parameters.v.data() + parameters.offset(window.x0, row);
    const V y = hn::Add(hn::Set(d, float(row - refinement.y)), half);
    for (int i = 0; i < window.width(); i += int(hn::Lanes(d))) {
      V u = hn::LoadU(d, u_row + i), v = hn::LoadU(d, v_row + i);
      auto active = hn::Gt(u, hn::Set(d, Parameters::not_covered / 2));
      if (!refinement.everywhere) active = hn::And(active, is_refined(d, refinement, u, v));
      if (hn::AllFalse(d, active)) continue;
      const V x = hn::Add(hn::ConvertTo(d, hn::Iota(di, window.x0 + i - refinement.x)), half);
      polish(d, refinement, x, y, active, u, v);
      hn::StoreU(u, d, u_row + i);
      hn::StoreU(v, d, v_row + i);
    }
  }
}

template <bool bilinear, class D, class V>
HWY_INLINE V polynomial(D d, const Bicubic<float>& c, V u, V v) {
  const auto row = [&](int i) {
    const V linear = hn::Set(d, c[i][1]);
    if constexpr (bilinear) return hn::Add(hn::Set(d, c[i][0]), hn::Mul(v, linear));
    const V upper = hn::Add(hn::Set(d, c[i][2]), hn::Mul(v, hn::Set(d, c[i][3])));
    return hn::Add(hn::Set(d, c[i][0]), hn::Mul(v, hn::Add(linear, hn::Mul(v, upper))));
  };
  if constexpr (bilinear) return hn::Add(row(0), hn::Mul(u, row(1)));
  const V upper = hn::Add(row(2), hn::Mul(u, row(3)));
  return hn::Add(row(0), hn::Mul(u, hn::Add(row(1), hn::Mul(u, upper))));
}

/// Rounds a channel to whole levels, 0..255.
template <class D, class V>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> to_level(D d, V channel) {
  const V inside = hn::Min(hn::Max(channel, hn::Zero(d)), hn::Set(d, 255.0F));
  return hn::ConvertTo(hn::RebindToSigned<D>(), hn::Add(inside, hn::Set(d, 0.5F)));
}

/// 8-bit colours over the ground, one channel after another.
template <bool bilinear, bool opaque, class D>
class Levels {
 public:
  using V = hn::Vec<D>;

  HWY_INLINE Levels(D, const PatchColor& color, V u, V v) : color_(color), u_(u), v_(v) {
    if constexpr (!opaque) {
      const D d;
      const V white = hn::Set(d, 255.0F);
      alpha_ = clamp01(d, polynomial<bilinear>(d, color.channels[3], u, v));
      if (color.masked_opacity)
        alpha_ = hn::Div(hn::ConvertTo(d, to_level(d, hn::Mul(alpha_, white))), white);
    }
  }

  HWY_INLINE hn::Vec<hn::RebindToSigned<D>> operator[](int n) const {
    const D d;
    V channel = polynomial<bilinear>(d, color_.channels[n], u_, v_);
    if constexpr (!opaque) {
      const V white = hn::Set(d, 255.0F);
      channel = color_.masked_opacity ? hn::ConvertTo(d, to_level(d, channel))
                                      : hn::Min(hn::Max(channel, hn::Zero(d)), white);
      const V through = hn::Mul(hn::Sub(hn::Set(d, 1.0F), alpha_), hn::Set(d, color_.ground));
      channel = hn::Add(hn::Mul(alpha_, channel), through);
    }
    return to_level(d, channel);
  }

 private:
  const PatchColor& color_;
  V u_, v_, alpha_;
};

/// Painted pixels of one row, as pointers to the first.
struct Row {
  const float *u, *v;
  std::uint32_t* top;
  std::array<std::uint8_t*, 3> rgb;
};

/// Paints the first `count` pixels of a row, up to as many as D has lanes.
template <bool bilinear, bool opaque, class D>
HWY_INLINE void shade_pixels(D d, const PatchColor& color, Face face, int count, const Row& row) {
  const hn::RebindToUnsigned<D> du;
  const hn::RebindToSigned<D> di;
  const hn::Rebind<std::uint8_t, D> bytes;
  const auto u = hn::LoadU(d, row.u);
  const auto covered = hn::And(hn::Gt(u, hn::Set(d, Parameters::not_covered / 2)),
                               hn::FirstN(d, std::size_t(count)));
  if (hn::AllFalse(d, covered)) return;

  // As TopFace::with.
  const auto alone = hn::Set(du, TopFace().with(face).sample());
  const auto face_on_top = hn::ShiftRight<1>(hn::BitCast(di, alone));
  const auto before = hn::LoadU(du, row.top);
  const auto face_before = hn::ShiftRight<1>(hn::BitCast(di, before));
  const auto same = hn::Or(hn::Eq(face_before, face_on_top), hn::Eq(face_before, hn::Zero(di)));
  const auto both = hn::Or(hn::Max(alone, before), hn::Set(du, 1u));
  const auto after = hn::IfThenElse(hn::RebindMask(du, same), hn::Or(before, alone), both);
  hn::StoreU(hn::IfThenElse(hn::RebindMask(du, covered), after, before), du, row.top);

  const Levels<bilinear, opaque, D> levels(d, color, u, hn::LoadU(d, row.v));
  const auto below = hn::Gt(face_before, face_on_top);
  const auto painted = hn::AndNot(below, hn::RebindMask(di, covered));
  for (int n = 0; n < 3; ++n) {
    const auto old = hn::PromoteTo(di, hn::LoadU(bytes, row.rgb[n]));
    hn::StoreU(hn::DemoteTo(bytes, hn::IfThenElse(painted, levels[n], old)), bytes, row.rgb[n]);
  }
}

/// Paints pixels of a row from `x` on, as many vectors as fit before `end`. Returns the pixel after
/// the last vector.
template <bool bilinear, bool opaque, class D>
HWY_INLINE int shade_row(D d, const PatchColor& color, Face face, int x, int end, int last,
                         Row& row) {
  const int lanes = int(hn::Lanes(d));
  for (; x < end && x + lanes <= last; x += lanes) {
    shade_pixels<bilinear, opaque>(d, color, face, end - x, row);
    row.u += lanes;
    row.v += lanes;
    row.top += lanes;
    for (std::uint8_t*& channel : row.rgb) channel += lanes;
  }
  return x;
}

/// Prefetches the pixels of a row, which are to be painted soon.
HWY_INLINE void prefetch(const Painting& painting, int y, Parameters::Extent extent) {
  constexpr int line = 64;
  if (extent.x0 >= extent.x1) return;
  for (int x = extent.x0; x < extent.x1; x += line / int(sizeof(std::uint32_t)))
    hwy::Prefetch(painting.top.at(x, y));
  hwy::Prefetch(painting.top.at(extent.x1 - 1, y));
  for (int c = 0; c < 3; ++c) {
    for (int x = extent.x0; x < extent.x1; x += line) hwy::Prefetch(painting.image.at(x, y, c));
    hwy::Prefetch(painting.image.at(extent.x1 - 1, y, c));
  }
}

template <bool bilinear, bool opaque>
void shade_rows(const PatchColor& color, Face face, const Parameters& parameters,
                Painting& painting) {
  const hn::CappedTag<float, 16> full;
  const hn::CappedTag<float, 1> single;
  const Window window = parameters.window;
  const int last = painting.window().x1;
  constexpr int ahead = 8;
  for (int y = window.y0; y < std::min(window.y0 + ahead, window.y1); ++y)
    prefetch(painting, y, parameters.extents[std::size_t(y - window.y0)]);
  for (int y = window.y0; y < window.y1; ++y) {
    if (y + ahead < window.y1)
      prefetch(painting, y + ahead, parameters.extents[std::size_t(y + ahead - window.y0)]);
    const auto [begin, end] = parameters.extents[std::size_t(y - window.y0)];
    if (begin >= end) continue;
    const std::size_t at = parameters.offset(begin, y);
    Row row{parameters.u.data() + at,
            parameters.v.data() + at,
            painting.top.at(begin, y),
            {painting.image.at(begin, y, 0), painting.image.at(begin, y, 1),
             painting.image.at(begin, y, 2)}};
    const int x = shade_row<bilinear, opaque>(full, color, face, begin, end, last, row);
    shade_row<bilinear, opaque>(single, color, face, x, end, last, row);
  }
}

void shade(const PatchColor& color, Face face, const Parameters& parameters, Painting& painting) {
  const auto rows = color.bilinear ? color.opaque ? shade_rows<true, true> : shade_rows<true, false>
                    : color.opaque ? shade_rows<false, true>
                                   : shade_rows<false, false>;
  rows(color, face, parameters, painting);
}

}  // namespace
}  // namespace gradmesh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gradmesh {

HWY_EXPORT(refine);
HWY_EXPORT(shade);

void find_parameters(const FaceShape& shape, Window window, Parameters& parameters) {
  parameters.window = window = window.clipped(shape.bounds);
  if (window.empty()) return;
  parameters.stride = std::size_t(window.width()) + row_padding;
  const std::size_t size = parameters.stride * std::size_t(window.height());
  if (parameters.u.size() < size) {
    parameters.u.resize(size);
    parameters.v.resize(size);
  }
  std::fill_n(parameters.u.begin(), size, Parameters::not_covered);
  if (shape.may_fold) std::fill_n(parameters.v.begin(), size, Parameters::not_covered);
  if (shape.traced) return invert(shape, parameters);
  parameters.extents.assign(std::size_t(window.height()), {window.x0, window.x1});
  cover(shape, parameters);
  if (shape.refinement.needed) HWY_DYNAMIC_DISPATCH(refine)(shape.refinement, parameters);
}

void fill_face(const FaceShape& shape, Face face, const PatchColor& color, Window window,
               Parameters& parameters, Painting& painting) {
  find_parameters(shape, window, parameters);
  if (!parameters.window.empty()) HWY_DYNAMIC_DISPATCH(shade)(color, face, parameters, painting);
}

}  // namespace gradmesh
#endif  // HWY_ONCE
