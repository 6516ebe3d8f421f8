// Read once for each target of Highway.
#if defined(GRADMESH_METRIC_ELEMENTARY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef GRADMESH_METRIC_ELEMENTARY_INL_H
#undef GRADMESH_METRIC_ELEMENTARY_INL_H
#else
#define GRADMESH_METRIC_ELEMENTARY_INL_H
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gradmesh::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Elementary functions of float vectors, from operations that IEEE 754 rounds in one way only, so
// that every processor gives the same bits.

/// Returns a x + b, rounded twice.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V scaled_sum(D d, float a, V x, float b) {
  return hn::Add(hn::Mul(hn::Set(d, a), x), hn::Set(d, b));
}

/// Returns the cube root of a positive normal number, to a relative error of 3e-7.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V cube_root(D d, V t) {
  // A float's bits are 2^23 (127 + log2) with the logarithm linear between powers of two. An offset
  // less a third of them gives the bits of r = t^(-1/3), right to 4 %.
  const hn::RebindToSigned<D> di;
  const auto offset = hn::Set(di, 0x54a23000);  // about 4/3 * 127 * 2^23
  const V bits = hn::ConvertTo(d, hn::BitCast(di, t));
  const auto third = hn::ConvertTo(di, hn::Mul(bits, hn::Set(d, 1.0F / 3.0F)));
  const V rough = hn::BitCast(d, hn::Sub(offset, third));
  // With e = 1 - t r^3 the exact t^(-1/3) is r (1 - e)^(-1/3) = r (1 + e/3 + 2/9 e^2 + ...), and
  // the root is t r^2 (1 - e)^(-2/3) = t r^2 (1 + 2/3 e + 5/9 e^2 + ...).
  const V one = hn::Set(d, 1.0F);
  const V e = hn::Sub(one, hn::Mul(hn::Mul(t, rough), hn::Mul(rough, rough)));
  const V r = hn::Add(rough, hn::Mul(rough, hn::Mul(e, scaled_sum(d, 2 / 9.0F, e, 1 / 3.0F))));
  const V root = hn::Mul(hn::Mul(t, r), r);
  const V rest = hn::Sub(one, hn::Mul(root, r));
  return hn::Add(root, hn::Mul(root, hn::Mul(rest, scaled_sum(d, 5 / 9.0F, rest, 2 / 3.0F))));
}

/// Returns the base-2 logarithm of a positive normal number; -127 for 0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V log2_positive(D d, V x) {
  // x = 2^exponent m with m from sqrt(1/2) to sqrt(2); log m = 2 atanh((m - 1) / (m + 1)).
  const hn::RebindToSigned<D> di;
  const auto bits = hn::BitCast(di, x);
  const auto exponent = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(di, 0x3f3504f3)));  // sqrt(1/2)
  const V m = hn::BitCast(d, hn::Sub(bits, hn::ShiftLeft<23>(exponent)));
  const V one = hn::Set(d, 1.0F);
  const V s = hn::Div(hn::Sub(m, one), hn::Add(m, one)), s2 = hn::Mul(s, s);
  V series = scaled_sum(d, 1 / 9.0F, s2, 1 / 7.0F);
  for (const float c : {1 / 5.0F, 1 / 3.0F, 1.0F})
    series = hn::Add(hn::Mul(s2, series), hn::Set(d, c));
  constexpr float scale = 2.88539008F;  // 2 / ln 2
  return hn::Add(hn::ConvertTo(d, exponent), hn::Mul(hn::Mul(hn::Set(d, scale), s), series));
}

/// Returns 2^y for -127 <= y < 127.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V exp2_bounded(D d, V y) {
  // Taylor's series on the part from -1/2 to 1/2, the rest in the exponent's bits.
  const hn::RebindToSigned<D> di;
  const auto biased = hn::ConvertTo(di, hn::Add(y, hn::Set(d, 127.5F)));
  const V whole = hn::ConvertTo(d, hn::Sub(biased, hn::Set(di, 127)));
  const V t = hn::Mul(hn::Sub(y, whole), hn::Set(d, 0.693147181F));
  V series = scaled_sum(d, 1 / 5040.0F, t, 1 / 720.0F);
  for (const float c : {1 / 120.0F, 1 / 24.0F, 1 / 6.0F, 1 / 2.0F, 1.0F, 1.0F})
    series = hn::Add(hn::Mul(t, series), hn::Set(d, c));
  return hn::Mul(series, hn::BitCast(d, hn::ShiftLeft<23>(biased)));
}

}  // namespace gradmesh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
