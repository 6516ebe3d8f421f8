// Read once for each target of Highway.
#if defined(GRADMESH_METRIC_FILTER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef GRADMESH_METRIC_FILTER_INL_H
#undef GRADMESH_METRIC_FILTER_INL_H
#else
#define GRADMESH_METRIC_FILTER_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>

#include "metric/padded_rows.h"
#include "metric/taps.h"

HWY_BEFORE_NAMESPACE();
namespace gradmesh::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Vectors as long as the target's, but no longer than the padding of rows.
template <class T>
using Lanes = hn::CappedTag<T, PaddedRows<T>::padding>;

/// Calls `body(tag, i)` for vectors from sample i on that cover exactly `count` samples, some of
/// them perhaps twice, for rows without padding.
template <class D, class Body>
HWY_INLINE void for_each_vector(D d, int count, const Body& body) {
  const int lanes = int(hn::Lanes(d));
  if (count < lanes) {
    for (int i = 0; i < count; ++i) body(hn::CappedTag<hn::TFromD<D>, 1>(), i);
    return;
  }
  for (int i = 0; i < count - lanes; i += lanes) body(d, i);
  body(d, count - lanes);
}

// A filter is a sum over pairs of samples, at the same distance before and after the output, from
// the farthest pair to the nearest. Every output adds its terms in this order, so that its value
// depends neither on the window nor on the target.

/// Adds a pair of samples under symmetric taps.
template <class D, class T, class V = hn::Vec<D>>
HWY_INLINE V add_even(D d, V total, T tap, V before, V after) {
  return hn::Add(total, hn::Mul(hn::Set(d, tap), hn::Add(before, after)));
}

/// Adds a pair of samples under antisymmetric taps, positive ahead. The sum is exactly 0 where the
/// input is flat.
template <class D, class T, class V = hn::Vec<D>>
HWY_INLINE V add_odd(D d, V total, T tap, V before, V after) {
  return hn::Add(total, hn::Mul(hn::Set(d, tap), hn::Sub(after, before)));
}

/// Adds a pair of samples under symmetric taps that sum to 0. The centre tap is not read but taken
/// to be minus the sum of the others, so that the result is exactly 0 where the input is flat.
template <class D, class T, class V = hn::Vec<D>>
HWY_INLINE V add_zero_sum(D d, V total, T tap, V before, V after, V twice_centre) {
  const V difference = hn::Sub(hn::Add(before, after), twice_centre);
  return hn::Add(total, hn::Mul(hn::Set(d, tap), difference));
}

/// Returns a vector of outputs of a symmetric filter, the first of them at `in`. `step` is the
/// distance between neighbours: 1 along a row, the stride down a column.
template <class D, class T, int Radius>
HWY_INLINE hn::Vec<D> filter_even(D d, const Taps<T, Radius>& taps, const T* in,
                                  std::ptrdiff_t step) {
  auto total = hn::Zero(d);
  for (int k = Radius; k > 0; --k)
    total =
        add_even(d, total, taps.at[k], hn::LoadU(d, in - k * step), hn::LoadU(d, in + k * step));
  return hn::Add(total, hn::Mul(hn::Set(d, taps.at[0]), hn::LoadU(d, in)));
}

}  // namespace gradmesh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
