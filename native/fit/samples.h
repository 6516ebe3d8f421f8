#pragma once

#include <Eigen/Core>
#include <array>

namespace gradmesh {

/// The products of the Hermite basis of Eq. 1 by which the control vectors of a patch, row by row,
/// count at (u, v).
std::array<double, 16> basis_products(double u, double v);

/// These at the middles of rows x columns equal parts of a patch, and their derivatives: a row for
/// each sample, a column for each control vector.
struct Samples {
  Eigen::MatrixXd at, by_u, by_v;
};

inline constexpr int most_samples = 20;

/// Rows along u and columns along v, each 1 to most_samples. Made once for each thread.
const Samples& samples_of(int rows, int columns);

}  // namespace gradmesh
