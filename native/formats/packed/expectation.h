#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace gradmesh {

/// What a whole number is expected to be where there are several ways to guess it: as the way says
/// that was off the least of late. So nobody has to write which way suits a mesh.
template <std::size_t ways>
class Expectation {
 public:
  /// Guesses in the order of the ways; one that is no number is none.
  using Guesses = std::array<double, ways>;

  /// Returns what is expected, in numbers that doubles count one by one; 0 without a guess.
  double of(const Guesses& guesses) const {
    constexpr double most = 0x1p52;
    std::size_t best = ways;
    for (std::size_t i = 0; i < ways; ++i)
      if (!std::isnan(guesses[i]) && (best == ways || off_[i] < off_[best])) best = i;
    return best == ways ? 0 : std::round(std::clamp(guesses[best], -most, most));
  }

  void learn(const Guesses& guesses, double number) {
    // A single absurd guess is soon forgotten.
    constexpr double memory = 0.875, most = 1000;
    for (std::size_t i = 0; i < ways; ++i)
      if (!std::isnan(guesses[i]))
        off_[i] = memory * off_[i] + std::min(std::abs(number - guesses[i]), most);
  }

 private:
  std::array<double, ways> off_{};
};

}  // namespace gradmesh
