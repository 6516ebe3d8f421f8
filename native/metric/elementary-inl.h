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

/// a x + b, rounded twice.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V scaled_sum(D d, float a, V x, float b) {
  return hn::Add(hn::Mul(hn::Set(d, a), x), hn::Set(d, b));
}

/// Cube root of a positive normal number, to a relative error of 3e-7.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V cube_root(D d, V t) {
  // A float's bits are 2^23 (127 + log2) with the logarithm linear between powers of two; their
  // third is right to 7 %, and each of Halley's steps takes the error to its cube.
  const hn::RebindToSigned<D> di;
  const auto offset = hn::Set(di, 0x2a555555);  // 2/3 * 127 * 2^23
  const V third_of_bits = hn::Mul(hn::ConvertTo(d, hn::BitCast(di, t)), hn::Set(d, 1.0F / 3.0F));
  V root = hn::BitCast(d, hn::Add(hn::ConvertTo(di, third_of_bits), offset));
  const V twice_t = hn::Add(t, t);
  for (int step = 0; step < 2; ++step) {
    const V cube = hn::Mul(hn::Mul(root, root), root);
    root = hn::Mul(root, hn::Div(hn::Add(cube, twice_t), hn::Add(hn::Add(cube, cube), t)));
  }
  return root;
}

/// Base-2 logarithm of a positive normal number; -127 for 0.
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

/// 2^y for -127 <= y < 127.
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

/// x^p for x >= 0, 0 < p <= 1, to a relative error of 2e-6 for x from 1e-9 to 1e5 and of 6e-6 for
/// other normal numbers; exactly 0 for x = 0, exactly 1 for x = 1.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V power(D d, V x, V p) {
  const V result = exp2_bounded(d, hn::Mul(p, log2_positive(d, x)));
  return hn::IfThenElseZero(hn::Gt(x, hn::Zero(d)), result);
}

}  // namespace gradmesh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
