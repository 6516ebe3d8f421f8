#pragma once

#include <Eigen/Core>
#include <array>

namespace gradmesh {

/// Returns the weights of the control vectors of a patch at (u, v), row by row: products of the
/// Hermite basis of Eq. 1.
std::array<double, 16> basis_products(double u, double v);

/// The basis products at the middles of rows x columns equal parts of a patch, and their
/// derivatives: a row for each sample, a column for each control vector.
struct Samples {
  Eigen::MatrixXd at, by_u, by_v;
};

inline constexpr int most_samples = 20;

/// Returns the samples of `rows` parts along u and `columns` along v, each 1 to most_samples. They
/// are made once for each thread.
const Samples& samples_of(int rows, int columns);

}  // namespace gradmesh
