#include <algorithm>

#include "raster/parameters.h"
#include "raster/segments.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/invert.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/newton-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gradmesh::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

template <class D>
HWY_INLINE hn::Vec<D> times(D d, float a, hn::Vec<D> b) {
  return hn::Mul(hn::Set(d, a), b);
}

template <class V>
struct Knot {
  V u, v, du, dv;
};

/// Runs Newton's method until the remaining distance is less than `knot_error` and the slopes are
/// off by less than `slope_error`. Returns the lanes in which that was not reached.
template <class D, class V, class M>
HWY_INLINE M solve(D d, const Refinement& refinement, V x, V y, M active, Knot<V>& knot) {
  const V slopes = hn::Set(d, slope_error), enough = hn::Set(d, 2 * knot_error);
  const auto& most = refinement.most;
  for (int n = 0; n < most_knot_steps; ++n) {
    const Position<V> at = position(d, refinement, knot.u, knot.v);
    const Step<V> step = approach(d, at, x, y, active, knot.u, knot.v);
    const V du = hn::Div(at.y.along_v, at.determinant);
    const V dv = hn::Neg(hn::Div(at.y.along_u, at.determinant));
    knot.du = hn::IfThenElse(active, du, knot.du);
    knot.dv = hn::IfThenElse(active, dv, knot.dv);
    // How much H_u and H_v can change on the way.
    const V u = hn::Abs(step.u), v = hn::Abs(step.v);
    const V of_u = hn::Add(times(d, most[2][0], u), times(d, most[1][1], v));
    const V of_v = hn::Add(times(d, most[1][1], u), times(d, most[0][2], v));
    const V off = hn::Add(hn::Mul(of_u, hn::Abs(du)), hn::Mul(of_v, hn::Abs(dv)));
    const V left = hn::Add(hn::Mul(of_u, u), hn::Mul(of_v, v));
    active = hn::AndNot(hn::And(hn::Le(off, slopes), hn::Le(left, enough)), active);
    if (hn::AllFalse(d, active)) break;
  }
  return active;
}

/// Finds the parameters of the nearest of some points of the surface.
template <class D, class V>
void find_start(D d, const Refinement& refinement, V x, V y, V& u, V& v) {
  V least = hn::Set(d, 1e30F);
  for (int i = 0; i <= start_cells; ++i)
    for (int j = 0; j <= start_cells; ++j) {
      const V u_here = hn::Set(d, float(i) / start_cells),
              v_here = hn::Set(d, float(j) / start_cells);
      const Position<V> at = position(d, refinement, u_here, v_here);
      const V dx = hn::Sub(x, at.x.value), dy = hn::Sub(y, at.y.value);
      const V distance = hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy));
      const auto nearer = hn::Lt(distance, least);
      least = hn::Min(least, distance);
      u = hn::IfThenElse(nearer, u_here, u);
      v = hn::IfThenElse(nearer, v_here, v);
    }
}

/// Bounds of the first three derivatives of a cubic over a segment.
template <class V>
struct Change {
  V first, second, third;
};

template <class D, class V>
HWY_INLINE Change<V> change(D d, V length, const float* value, const float* slope) {
  const auto most = [](V a, V b) { return hn::Max(hn::Abs(a), hn::Abs(b)); };
  const V m0 = hn::LoadU(d, slope), m1 = hn::LoadU(d, slope + 1);
  const V rise = hn::Div(hn::Sub(hn::LoadU(d, value + 1), hn::LoadU(d, value)), length);
  // The slope's Bezier coefficients are m0, middle, m1.
  const V middle = hn::Sub(times(d, 3, rise), hn::Add(m0, m1));
  const V to_middle = hn::Sub(middle, m0), from_middle = hn::Sub(m1, middle);
  const V per_length = hn::Div(hn::Set(d, 2.0F), length);
  return {hn::Max(most(m0, m1), hn::Abs(middle)), hn::Mul(per_length, most(to_middle, from_middle)),
          hn::Div(hn::Mul(per_length, hn::Abs(hn::Sub(from_middle, to_middle))), length)};
}

/// Returns a bound of the fourth derivative of H(u(x), v(x)), by the chain rule, four times.
template <class D, class V>
HWY_INLINE V fourth_derivative(D d, const Refinement& refinement, const Change<V>& u,
                               const Change<V>& v) {
  const auto& most = refinement.most;
  const V uu = hn::Mul(u.first, u.first), uv = hn::Mul(u.first, v.first),
          vv = hn::Mul(v.first, v.first);
  const auto sum = [](V a, V b, V c) { return hn::Add(hn::Add(a, b), c); };
  const V of_fourth = hn::Mul(uv, sum(times(d, 4 * most[3][1], uu), times(d, 6 * most[2][2], uv),
                                      times(d, 4 * most[1][3], vv)));
  const V u_twice =
      sum(times(d, most[3][0], uu), times(d, 2 * most[2][1], uv), times(d, most[1][2], vv));
  const V v_twice =
      sum(times(d, most[2][1], uu), times(d, 2 * most[1][2], uv), times(d, most[0][3], vv));
  const V of_third = times(d, 6, hn::Add(hn::Mul(u_twice, u.second), hn::Mul(v_twice, v.second)));
  const auto second = [&](V a, V b, V to_a, V to_b) {
    return sum(times(d, most[2][0], hn::Mul(a, to_a)),
               times(d, most[1][1], hn::Add(hn::Mul(a, to_b), hn::Mul(b, to_a))),
               times(d, most[0][2], hn::Mul(b, to_b)));
  };
  const V of_second = hn::Add(times(d, 3, second(u.second, v.second, u.second, v.second)),
                              times(d, 4, second(u.first, v.first, u.third, v.third)));
  return sum(of_fourth, of_third, of_second);
}

/// Returns for the knots from `i` on whether cubic interpolation up to the next knot is near
/// enough. Along a row the place on the surface is off by r, with r = r' = 0 at both ends but for
/// the knots' own errors, so |r| <= length^4 / 384 max |r''''|.
template <class D>
HWY_INLINE hn::Mask<D> are_near(D d, const Refinement& refinement, const Knots& knots,
                                std::size_t i) {
  using V = hn::Vec<D>;
  const V length = hn::Max(hn::LoadU(d, &knots.length[i]), hn::Set(d, 1.0F));
  const V fourth = fourth_derivative(d, refinement, change(d, length, &knots.u[i], &knots.du[i]),
                                     change(d, length, &knots.v[i], &knots.dv[i]));
  // Knots on the border may lie outside.
  const auto on_border = [&](const float* t) {
    const V here = hn::LoadU(d, t), next = hn::LoadU(d, t + 1);
    return hn::Or(hn::Le(hn::Min(here, next), hn::Zero(d)),
                  hn::Ge(hn::Max(here, next), hn::Set(d, 1.0F)));
  };
  const V allowed = hn::IfThenElse(hn::Or(on_border(&knots.u[i]), on_border(&knots.v[i])),
                                   hn::Set(d, interpolation_error - float(flatness)),
                                   hn::Set(d, interpolation_error));
  const V squared = hn::Mul(length, length);
  return hn::Le(hn::Mul(times(d, 1.0F / 384, hn::Mul(squared, squared)), fourth), allowed);
}

/// Finds the parameters at all knots, and whether those of the pixels between are to be
/// interpolated.
void solve_knots(const Refinement& refinement, std::size_t count, Knots& knots) {
  const hn::CappedTag<float, 16> d;
  using V = hn::Vec<decltype(d)>;
  const auto plane = [&](const std::array<float, 3>& p, V x, V y) {
    return clamp01(d, hn::Add(hn::Set(d, p[0]),
                              hn::Add(hn::Mul(x, hn::Set(d, p[1])), hn::Mul(y, hn::Set(d, p[2])))));
  };
  const std::size_t lanes = hn::Lanes(d);
  const auto all = hn::FirstN(d, lanes);
  for (std::size_t i = 0; i < count; i += lanes) {
    const V x = hn::LoadU(d, &knots.x[i]), y = hn::LoadU(d, &knots.y[i]);
    Knot<V> knot{plane(refinement.start_u, x, y), plane(refinement.start_v, x, y), hn::Zero(d),
                 hn::Zero(d)};
    auto lost = solve(d, refinement, x, y, all, knot);
    if (!hn::AllFalse(d, lost)) {
      V u = knot.u, v = knot.v;
      find_start(d, refinement, x, y, u, v);
      knot.u = hn::IfThenElse(lost, u, knot.u);
      knot.v = hn::IfThenElse(lost, v, knot.v);
      lost = solve(d, refinement, x, y, lost, knot);
    }
    hn::StoreU(knot.u, d, &knots.u[i]);
    hn::StoreU(knot.v, d, &knots.v[i]);
    hn::StoreU(hn::IfThenZeroElse(lost, knot.du), d, &knots.du[i]);
    hn::StoreU(hn::IfThenZeroElse(lost, knot.dv), d, &knots.dv[i]);
    hn::StoreU(hn::IfThenElseZero(hn::Not(lost), hn::Set(d, 1.0F)), d, &knots.near[i]);
  }
  for (std::size_t i = 0; i < count; i += lanes) {
    const auto near = are_near(d, refinement, knots, i);
    const V solved = hn::Min(hn::LoadU(d, &knots.near[i]), hn::LoadU(d, &knots.near[i + 1]));
    hn::StoreU(hn::IfThenElseZero(near, solved), d, &knots.near[i]);
  }
}

/// Writes the parameters of `count` pixels of the segment that begins at the knot to u_at and v_at,
/// from pixel `first` on, counted from the knot.
void fill_segment(const Refinement& refinement, const Knots& knots, std::size_t knot, int first,
                  int count, float* u_at, float* v_at) {
  const hn::CappedTag<float, most_length> d;
  const hn::RebindToSigned<decltype(d)> di;
  using V = hn::Vec<decltype(d)>;
  // Elsewhere Newton's method starts from the straight line between the knots.
  const bool near = knots.near[knot] > 0;
  const InterpolationBasis& basis =
      (near ? hermite_bases : linear_bases)[std::size_t(knots.length[knot])];
  const auto between = [&](const std::vector<float>& value, const std::vector<float>& slope,
                           int i) {
    const auto term = [&](int n, float factor) {
      return hn::Mul(hn::Set(d, factor), hn::LoadU(d, &basis[n][i]));
    };
    return hn::Add(hn::Add(term(0, value[knot]), term(1, value[knot + 1])),
                   hn::Add(term(2, slope[knot]), term(3, slope[knot + 1])));
  };
  const int lanes = int(hn::Lanes(d));
  for (int i = 0; i < count; i += lanes) {
    const auto wanted = hn::FirstN(d, std::size_t(std::min(lanes, count - i)));
    V u = between(knots.u, knots.du, first + i), v = between(knots.v, knots.dv, first + i);
    auto active = hn::Or(hn::Ne(clamp01(d, u), u), hn::Ne(clamp01(d, v), v));
    active = hn::And(wanted, near ? active : wanted);
    if (HWY_UNLIKELY(!hn::AllFalse(d, active))) {
      u = clamp01(d, u);
      v = clamp01(d, v);
      const V x = hn::Add(hn::Set(d, knots.x[knot]), hn::ConvertTo(d, hn::Iota(di, first + i)));
      polish(d, refinement, x, hn::Set(d, knots.y[knot]), active, u, v);
    }
    hn::BlendedStore(u, wanted, d, u_at + i);
    hn::BlendedStore(v, wanted, d, v_at + i);
  }
}

/// Calls f(span, first segment, end of the segments) for each span of the shape that meets the
/// window, row by row.
template <class F>
void for_each_span(const FaceShape& shape, Window window, const F& f) {
  const auto above = [](const Span& span, int y) { return span.y < y; };
  auto span = std::lower_bound(shape.spans.begin(), shape.spans.end(), window.y0, above);
  for (; span != shape.spans.end() && span->y < window.y1; ++span) {
    const int x0 = std::max(span->x0, window.x0), x1 = std::min(span->x1, window.x1);
    if (x0 < x1) f(*span, (x0 - span->x0) / most_length, (x1 - 1 - span->x0) / most_length + 1);
  }
}

/// Puts knots at the ends of all segments that meet the window. Returns the number of knots.
std::size_t place_knots(const FaceShape& shape, Window window, Knots& knots) {
  std::size_t count = 0;
  for_each_span(shape, window,
                [&](const Span&, int first, int end) { count += std::size_t(end - first + 1); });
  knots.resize(count + row_padding + 1);
  if (count == 0) return 0;
  std::size_t at = 0;
  for_each_span(shape, window, [&](const Span& span, int first, int end) {
    const int last = span.x1 - span.x0 - 1;
    for (int k = first; k <= end; ++k) {
      const int here = std::min(k * most_length, last);
      knots.x[at] = float(span.x0 + here - shape.refinement.x) + 0.5F;
      knots.y[at] = float(span.y - shape.refinement.y) + 0.5F;
      knots.length[at++] = float(std::min(here + most_length, last) - here);
    }
  });
  // The last vector is filled with the last.
  std::fill_n(&knots.x[count], row_padding, knots.x[count - 1]);
  std::fill_n(&knots.y[count], row_padding, knots.y[count - 1]);
  std::fill_n(&knots.length[count], row_padding, 0.0F);
  return count;
}

void invert_all(const FaceShape& shape, Parameters& parameters) {
  const Window window = parameters.window;
  const Knots& knots = parameters.knots;
  parameters.extents.assign(std::size_t(window.height()), {0, 0});
  solve_knots(shape.refinement, place_knots(shape, window, parameters.knots), parameters.knots);
  std::size_t knot = 0;
  for_each_span(shape, window, [&](const Span& span, int first, int end) {
    const int x0 = std::max(span.x0, window.x0), x1 = std::min(span.x1, window.x1);
    Parameters::Extent& extent = parameters.extents[std::size_t(span.y - window.y0)];
    if (extent.x0 == extent.x1) extent.x0 = x0;
    extent.x1 = x1;
    for (int k = first; k < end; ++k, ++knot) {
      const int start = span.x0 + k * most_length;
      const int from = std::max(start, x0), to = std::min(start + most_length, x1);
      const std::size_t offset = parameters.offset(from, span.y);
      fill_segment(shape.refinement, knots, knot, from - start, to - from,
                   parameters.u.data() + offset, parameters.v.data() + offset);
    }
    // A span's last knot begins no segment.
    ++knot;
  });
}

}  // namespace
}  // namespace gradmesh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gradmesh {

HWY_EXPORT(invert_all);

void invert(const FaceShape& shape, Parameters& parameters) {
  HWY_DYNAMIC_DISPATCH(invert_all)(shape, parameters);
}

}  // namespace gradmesh
#endif  // HWY_ONCE
