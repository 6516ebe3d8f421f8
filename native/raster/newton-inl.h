// Read once for each target of Highway.
#if defined(GRADMESH_RASTER_NEWTON_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef GRADMESH_RASTER_NEWTON_INL_H
#undef GRADMESH_RASTER_NEWTON_INL_H
#else
#define GRADMESH_RASTER_NEWTON_INL_H
#endif

#include <hwy/highway.h>

#include "raster/segments.h"
#include "raster/tessellate.h"

HWY_BEFORE_NAMESPACE();
namespace gradmesh::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// From pixels to parameters, by Newton's method.

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

/// Returns the step along one parameter that comes closest to (dx, dy) after a step of `other`
/// along the other parameter.
template <class V>
HWY_INLINE V closest(V dx, V dy, V along_x, V along_y, V other, V other_x, V other_y) {
  const V x = hn::Sub(dx, hn::Mul(other, other_x)), y = hn::Sub(dy, hn::Mul(other, other_y));
  return hn::Div(hn::Add(hn::Mul(x, along_x), hn::Mul(y, along_y)),
                 hn::Add(hn::Mul(along_x, along_x), hn::Mul(along_y, along_y)));
}

template <class V>
struct Position {
  Derivatives<V> x, y;
  /// Determinant of the Jacobian.
  V determinant;
};

template <class D, class V>
HWY_INLINE Position<V> position(D d, const Refinement& refinement, V u, V v) {
  const Derivatives<V> x = derivatives(d, refinement.position[0], u, v);
  const Derivatives<V> y = derivatives(d, refinement.position[1], u, v);
  return {x, y, hn::Sub(hn::Mul(x.along_u, y.along_v), hn::Mul(x.along_v, y.along_u))};
}

/// Takes the `active` parameters a step of Newton's method nearer to the position (x, y), but not
/// out of the patch: pieces of its outline may lie beyond it, and then the nearest point counts.
/// Returns the step as it would be without that limit. `at` is the surface at (u, v).
template <class D, class V, class M>
HWY_INLINE Step<V> approach(D d, const Position<V>& at, V x, V y, M active, V& u, V& v) {
  const Derivatives<V>&px = at.x, &py = at.y;
  const V dx = hn::Sub(x, px.value), dy = hn::Sub(y, py.value);
  const Step<V> step{
      hn::Div(hn::Sub(hn::Mul(dx, py.along_v), hn::Mul(dy, px.along_v)), at.determinant),
      hn::Div(hn::Sub(hn::Mul(dy, px.along_u), hn::Mul(dx, py.along_u)), at.determinant)};
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

/// Runs Newton's method until the remaining distance is less than `flatness`. After a step of (du,
/// dv) that distance is at most (uu du^2 + 2 uv du dv + vv dv^2) / 2. One step nearly always
/// suffices.
template <class D, class V, class M>
HWY_INLINE void polish(D d, const Refinement& refinement, V x, V y, M active, V& u, V& v) {
  const auto& most = refinement.most;
  const V uu = hn::Set(d, most[2][0]), uv = hn::Set(d, 2 * most[1][1]), vv = hn::Set(d, most[0][2]),
          enough = hn::Set(d, float(2 * flatness));
  for (int n = 0; n < most_polish_steps; ++n) {
    const Step<V> step = approach(d, position(d, refinement, u, v), x, y, active, u, v);
    const V left =
        hn::Add(hn::Add(hn::Mul(uu, hn::Mul(step.u, step.u)), hn::Mul(vv, hn::Mul(step.v, step.v))),
                hn::Mul(uv, hn::Abs(hn::Mul(step.u, step.v))));
    active = hn::And(active, hn::Gt(left, enough));
    if (hn::AllFalse(d, active)) break;
  }
}

}  // namespace gradmesh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
