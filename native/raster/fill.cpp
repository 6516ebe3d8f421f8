#include "raster/fill.h"

#include <algorithm>

#include <hwy/cache_control.h>

#include "raster/cover.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/fill.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gradmesh::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// A value of a bicubic and its derivatives.
template <class V>
struct Derivatives {
  V value, along_u, along_v;
};

template <class D, class V>
HWY_INLINE Derivatives<V> derivatives(D d, const Bicubic<float>& c, V u, V v) {
  V row[4], slope[4];
  for (int i = 0; i < 4; ++i) {
    const V c1 = hn::Set(d, c[i][1]), c2 = hn::Set(d, c[i][2]), c3 = hn::Set(d, c[i][3]);
    const V a = hn::Add(c2, hn::Mul(v, c3)), b = hn::Add(c1, hn::Mul(v, a));
    row[i] = hn::Add(hn::Set(d, c[i][0]), hn::Mul(v, b));
    slope[i] = hn::Add(b, hn::Mul(v, hn::Add(a, hn::Mul(v, c3))));
  }
  const V a = hn::Add(row[2], hn::Mul(u, row[3])), b = hn::Add(row[1], hn::Mul(u, a));
  return {
      hn::Add(row[0], hn::Mul(u, b)), hn::Add(b, hn::Mul(u, hn::Add(a, hn::Mul(u, row[3])))),
      hn::Add(slope[0],
              hn::Mul(u, hn::Add(slope[1], hn::Mul(u, hn::Add(slope[2], hn::Mul(u, slope[3]))))))};
}

template <class V>
struct Step {
  V u, v;
};

template <class D, class V>
HWY_INLINE V clamp01(D d, V x) {
  return hn::Min(hn::Max(x, hn::Zero(d)), hn::Set(d, 1.0F));
}

/// How far to go along one parameter to come closest to (dx, dy) after going `other` along the
/// other one.
template <class V>
HWY_INLINE V closest(V dx, V dy, V along_x, V along_y, V other, V other_x, V other_y) {
  const V x = hn::Sub(dx, hn::Mul(other, other_x)), y = hn::Sub(dy, hn::Mul(other, other_y));
  return hn::Div(hn::Add(hn::Mul(x, along_x), hn::Mul(y, along_y)),
                 hn::Add(hn::Mul(along_x, along_x), hn::Mul(along_y, along_y)));
}

/// Takes the `active` parameters a step of Newton's method nearer to the position (x, y), but not
/// out of the patch: pieces of its outline may lie beyond it, and then the nearest point counts.
/// Returns the step as it would be without that.
template <class D, class V, class M>
HWY_INLINE Step<V> approach(D d, const Refinement& refinement, V x, V y, M active, V& u, V& v) {
  const Derivatives<V> px = derivatives(d, refinement.position[0], u, v);
  const Derivatives<V> py = derivatives(d, refinement.position[1], u, v);
  const V dx = hn::Sub(x, px.value), dy = hn::Sub(y, py.value);
  const V jacobian = hn::Sub(hn::Mul(px.along_u, py.along_v), hn::Mul(px.along_v, py.along_u));
  const Step<V> step{hn::Div(hn::Sub(hn::Mul(dx, py.along_v), hn::Mul(dy, px.along_v)), jacobian),
                     hn::Div(hn::Sub(hn::Mul(dy, px.along_u), hn::Mul(dx, py.along_u)), jacobian)};
  const V free_u = hn::Add(u, step.u), free_v = hn::Add(v, step.v);
  V next_u = clamp01(d, free_u), next_v = clamp01(d, free_v);
  const M out_u = hn::And(active, hn::Ne(next_u, free_u));
  const M out_v = hn::And(active, hn::Ne(next_v, free_v));
  if (!hn::AllFalse(d, hn::Or(out_u, out_v))) {
    const V along_v =
        closest(dx, dy, px.along_v, py.along_v, hn::Sub(next_u, u), px.along_u, py.along_u);
    next_v = hn::IfThenElse(out_u, clamp01(d, hn::Add(v, along_v)), next_v);
    const V along_u =
        closest(dx, dy, px.along_u, py.along_u, hn::Sub(next_v, v), px.along_v, py.along_v);
    next_u = hn::IfThenElse(out_v, clamp01(d, hn::Add(u, along_u)), next_u);
  }
  u = hn::IfThenElse(active, next_u, u);
  v = hn::IfThenElse(active, next_v, v);
  return step;
}

/// Whether Newton's method is to be used at each of these parameters.
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

/// Newton's method, pixel by pixel until what is left is less than `flatness`: after a step of
/// (du, dv) that is at most (uu du^2 + 2 uv du dv + vv dv^2) / 2. One step nearly always does.
void refine(const Refinement& refinement, Parameters& parameters) {
  // Longer vectors would be filled less well.
  const hn::CappedTag<float, 8> d;
  const hn::RebindToSigned<decltype(d)> di;
  using V = hn::Vec<decltype(d)>;
  constexpr int most_steps = 4;
  const V uu = hn::Set(d, refinement.uu), uv = hn::Set(d, 2 * refinement.uv),
          vv = hn::Set(d, refinement.vv), enough = hn::Set(d, float(2 * flatness));
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
      for (int n = 0; n < most_steps; ++n) {
        const Step<V> step = approach(d, refinement, x, y, active, u, v);
        const V left = hn::Add(
            hn::Add(hn::Mul(uu, hn::Mul(step.u, step.u)), hn::Mul(vv, hn::Mul(step.v, step.v))),
            hn::Mul(uv, hn::Abs(hn::Mul(step.u, step.v))));
        active = hn::And(active, hn::Gt(left, enough));
        if (hn::AllFalse(d, active)) break;
      }
      hn::StoreU(u, d, u_row + i);
      hn::StoreU(v, d, v_row + i);
    }
  }
}

template <class D, class V>
HWY_INLINE V polynomial(D d, bool bilinear, const Bicubic<float>& c, V u, V v) {
  const auto row = [&](int i) {
    const V linear = hn::Set(d, c[i][1]);
    if (bilinear) return hn::Add(hn::Set(d, c[i][0]), hn::Mul(v, linear));
    const V upper = hn::Add(hn::Set(d, c[i][2]), hn::Mul(v, hn::Set(d, c[i][3])));
    return hn::Add(hn::Set(d, c[i][0]), hn::Mul(v, hn::Add(linear, hn::Mul(v, upper))));
  };
  if (bilinear) return hn::Add(row(0), hn::Mul(u, row(1)));
  const V upper = hn::Add(row(2), hn::Mul(u, row(3)));
  return hn::Add(row(0), hn::Mul(u, hn::Add(row(1), hn::Mul(u, upper))));
}

/// To whole levels, 0..255.
template <class D, class V>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> to_level(D d, V channel) {
  const V inside = hn::Min(hn::Max(channel, hn::Zero(d)), hn::Set(d, 255.0F));
  return hn::ConvertTo(hn::RebindToSigned<D>(), hn::Add(inside, hn::Set(d, 0.5F)));
}

/// 8-bit colours over white.
template <class D, class V>
HWY_INLINE void levels(D d, const PatchColor& color, V u, V v,
                       hn::Vec<hn::RebindToSigned<D>>* rgb) {
  if (color.opaque) {
    for (int n = 0; n < 3; ++n)
      rgb[n] = to_level(d, polynomial(d, color.bilinear, color.channels[n], u, v));
    return;
  }
  const V white = hn::Set(d, 255.0F), one = hn::Set(d, 1.0F);
  V alpha = polynomial(d, color.bilinear, color.channels[3], u, v);
  alpha = hn::Min(hn::Max(alpha, hn::Zero(d)), one);
  if (color.masked_opacity)
    alpha = hn::Div(hn::ConvertTo(d, to_level(d, hn::Mul(alpha, white))), white);
  const V through = hn::Mul(hn::Sub(one, alpha), white);
  for (int n = 0; n < 3; ++n) {
    V channel = polynomial(d, color.bilinear, color.channels[n], u, v);
    channel = color.masked_opacity ? hn::ConvertTo(d, to_level(d, channel))
                                   : hn::Min(hn::Max(channel, hn::Zero(d)), white);
    rgb[n] = to_level(d, hn::Add(hn::Mul(alpha, channel), through));
  }
}

/// Painted pixels of one row, as pointers to the first.
struct Row {
  const float *u, *v;
  std::uint32_t* top;
  std::array<std::uint8_t*, 3> rgb;
};

/// Paints as many pixels of a row as D has lanes.
template <class D>
HWY_INLINE void shade_pixels(D d, const PatchColor& color, Face face, const Row& row) {
  const hn::RebindToUnsigned<D> du;
  const hn::RebindToSigned<D> di;
  const hn::Rebind<std::uint8_t, D> bytes;
  const auto u = hn::LoadU(d, row.u);
  const auto covered = hn::Gt(u, hn::Set(d, Parameters::not_covered / 2));
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

  hn::Vec<decltype(di)> level[3];
  levels(d, color, u, hn::LoadU(d, row.v), level);
  const auto below = hn::Gt(face_before, face_on_top);
  const auto painted = hn::AndNot(below, hn::RebindMask(di, covered));
  for (int n = 0; n < 3; ++n) {
    const auto old = hn::PromoteTo(di, hn::LoadU(bytes, row.rgb[n]));
    hn::StoreU(hn::DemoteTo(bytes, hn::IfThenElse(painted, level[n], old)), bytes, row.rgb[n]);
  }
}

/// Paints column after column, each as wide as the vectors of D, to which the window's width is at
/// least equal. The last may overlap the one before: painting a pixel twice changes nothing. (In
/// rows, a vector would have to wait for what it shares with the one just stored.)
template <class D>
void shade_columns(D d, const PatchColor& color, Face face, const Parameters& parameters,
                   Painting& painting) {
  const Window window = parameters.window;
  const int lanes = int(hn::Lanes(d));
  const std::size_t step = std::size_t(painting.image.width);
  for (int next = window.x0; next < window.x1; next += lanes) {
    const int x = std::min(next, window.x1 - lanes), y = window.y0;
    const std::size_t at = parameters.offset(x, y);
    Row row{parameters.u.data() + at,
            parameters.v.data() + at,
            painting.top.at(x, y),
            {painting.image.at(x, y, 0), painting.image.at(x, y, 1), painting.image.at(x, y, 2)}};
    for (int i = 0; i < window.height(); ++i) {
      shade_pixels(d, color, face, row);
      row.u += parameters.stride;
      row.v += parameters.stride;
      row.top += step;
      for (std::uint8_t*& channel : row.rgb) channel += step;
    }
  }
}

void shade(const PatchColor& color, Face face, const Parameters& parameters, Painting& painting) {
  const hn::CappedTag<float, 16> full;
  const hn::CappedTag<float, 4> quarter;
  const hn::CappedTag<float, 1> single;
  const std::size_t width = std::size_t(parameters.window.width());
  if (width >= hn::Lanes(full))
    shade_columns(full, color, face, parameters, painting);
  else if (width >= hn::Lanes(quarter))
    shade_columns(quarter, color, face, parameters, painting);
  else
    shade_columns(single, color, face, parameters, painting);
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
  cover(shape, parameters);
  if (shape.refinement.needed) HWY_DYNAMIC_DISPATCH(refine)(shape.refinement, parameters);
}

/// Asks for the pixels that are about to be painted, which come while their parameters are found.
void prefetch(const Painting& painting, Window window) {
  constexpr int line = 64, most_pixels = 1 << 14;
  if (window.width() * window.height() > most_pixels) return;
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; x += line / int(sizeof(std::uint32_t)))
      hwy::Prefetch(painting.top.at(x, y));
    hwy::Prefetch(painting.top.at(window.x1 - 1, y));
    for (int c = 0; c < 3; ++c) {
      for (int x = window.x0; x < window.x1; x += line) hwy::Prefetch(painting.image.at(x, y, c));
      hwy::Prefetch(painting.image.at(window.x1 - 1, y, c));
    }
  }
}

void fill_face(const FaceShape& shape, Face face, const PatchColor& color, Window window,
               Parameters& parameters, Painting& painting) {
  prefetch(painting, window.clipped(shape.bounds));
  find_parameters(shape, window, parameters);
  if (!parameters.window.empty()) HWY_DYNAMIC_DISPATCH(shade)(color, face, parameters, painting);
}

}  // namespace gradmesh
#endif  // HWY_ONCE
