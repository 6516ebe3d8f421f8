#pragma once

#include <array>

namespace gradmesh {

/// One half of a symmetric or antisymmetric filter: the tap at the centre, then outwards.
template <class T, int Radius>
struct Taps {
  static constexpr int radius = Radius;
  std::array<T, Radius + 1> at{};
};

/// Returns the taps `weight(0)`, `weight(1)`, ... in double.
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

}  // namespace gradmesh
