#pragma once

#include <array>

namespace gradmesh {

/// Returns the weights of the control vectors of a patch at (u, v), row by row: products of the
/// Hermite basis of Eq. 1.
std::array<double, 16> basis_products(double u, double v);

inline constexpr int most_samples = 20;

/// The Hermite basis of Eq. 1 at the middles of equal parts of a parameter, and its derivatives:
/// for each of its four functions a value for each part.
struct Parts {
  using Values = std::array<std::array<double, most_samples>, 4>;
  int count = 0;
  Values at = {}, along = {};
};

/// Returns the basis at the middles of 1 to most_samples parts.
const Parts& parts_of(int count);

/// Sets values at the samples of u.count x v.count parts of a patch, row by row: those of the sum
/// of `control` by basis products, one after the other. The sum over the rows of `control` is the
/// same for all samples of a row, so a sample takes four products instead of sixteen.
void sum_up(const std::array<double, 16>& control, const Parts::Values& u, int rows,
            const Parts::Values& v, int columns, double* values);

}  // namespace gradmesh
