#pragma once

#include <array>
#include <cstddef>

namespace gradmesh {

/// One half of a symmetric or antisymmetric filter: the tap at the centre, then outwards.
template <class T, int Radius>
struct Taps {
  static constexpr int radius = Radius;
  std::array<T, Radius + 1> at{};
};

/// Samples `weight(0)`, `weight(1)`, ... in double.
template <int Radius, class Weight>
Taps<double, Radius> sample_taps(const Weight& weight) {
  Taps<double, Radius> taps;
  for (int k = 0; k <= Radius; ++k) taps.at[k] = weight(k);
  return taps;
}

template <int Radius>
double sum(const Taps<double, Radius>& taps) {
  double total = taps.at[0];
  for (int k = 1; k <= Radius; ++k) total += 2 * taps.at[k];
  return total;
}

template <class T, int Radius>
Taps<T, Radius> scaled(const Taps<double, Radius>& taps, double factor) {
  Taps<T, Radius> result;
  for (int k = 0; k <= Radius; ++k) result.at[k] = T(taps.at[k] * factor);
  return result;
}

// The filters below run along a row or down a column: `in` is the sample at the first output,
// `step` the distance between neighbours along the filter (1, or the number of interleaved
// channels, or the stride). They write `count` consecutive outputs and read `radius` steps to
// both sides of each. Every output adds its terms in the same order, so a pixel's value does not
// depend on the window. The loop over taps unrolls, the loop over outputs vectorises.

/// Symmetric taps.
template <class T, int Radius>
void filter_even(const Taps<T, Radius>& taps, const T* in, std::ptrdiff_t step,
                 std::ptrdiff_t count, T* __restrict out) {
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    T total = 0;
    for (int k = Radius; k > 0; --k) total += taps.at[k] * (in[i - k * step] + in[i + k * step]);
    out[i] = total + taps.at[0] * in[i];
  }
}

/// Antisymmetric taps, positive ahead; exactly 0 where the input is flat.
template <class T, int Radius>
void filter_odd(const Taps<T, Radius>& taps, const T* in, std::ptrdiff_t step, std::ptrdiff_t count,
                T* __restrict out) {
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    T total = 0;
    for (int k = Radius; k > 0; --k) total += taps.at[k] * (in[i + k * step] - in[i - k * step]);
    out[i] = total;
  }
}

/// Symmetric taps that sum to 0. The centre tap is not read: it stands for minus the others, so
/// that the result is exactly 0 where the input is flat.
template <class T, int Radius>
void filter_even_zero_sum(const Taps<T, Radius>& taps, const T* in, std::ptrdiff_t step,
                          std::ptrdiff_t count, T* __restrict out) {
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const T twice = in[i] + in[i];
    T total = 0;
    for (int k = Radius; k > 0; --k) {
      total += taps.at[k] * ((in[i - k * step] + in[i + k * step]) - twice);
    }
    out[i] = total;
  }
}

/// Symmetric taps that sum to 1. The centre tap is not read: it stands for what the others leave,
/// so that the input passes exactly where it is flat and rounds little where it is nearly so.
template <class T, int Radius>
void filter_even_unit_sum(const Taps<T, Radius>& taps, const T* in, std::ptrdiff_t step,
                          std::ptrdiff_t count, T* __restrict out) {
  filter_even_zero_sum(taps, in, step, count, out);
  for (std::ptrdiff_t i = 0; i < count; ++i) out[i] += in[i];
}

}  // namespace gradmesh
