#pragma once

#include <algorithm>
#include <limits>
#include <vector>

namespace gradmesh {

/// The damping of Levenberg and Marquardt, a number for each unknown: it falls where a step helped,
/// and rises where it did harm.
class Damping {
 public:
  explicit Damping(std::size_t unknowns, double largest = std::numeric_limits<double>::infinity())
      : values_(unknowns, first), most_(largest) {}

  const std::vector<double>& values() const { return values_; }
  void lower(std::size_t unknown) {
    values_[unknown] = std::max(least, values_[unknown] / falls_by);
  }
  /// Raises it by less where `again` is true, after it was raised for the same step.
  void raise(std::size_t unknown, bool again = false) {
    values_[unknown] = std::min(most_, values_[unknown] * (again ? rises_again_by : rises_by));
  }
  /// Lets the unknown stay where it is.
  void hold(std::size_t unknown) { values_[unknown] = 1e12; }

 private:
  static constexpr double first = 1e-3, least = 1e-4;
  static constexpr double rises_by = 20, rises_again_by = 3, falls_by = 4;

  std::vector<double> values_;
  double most_;
};

}  // namespace gradmesh
