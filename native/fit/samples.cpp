#include "fit/samples.h"

#include <memory>

#include "base/per_thread.h"
#include "geom/hermite.h"

namespace gradmesh {
namespace {

using Basis = std::array<double, 4>;

std::array<double, 16> products(const Basis& u, const Basis& v) {
  std::array<double, 16> result;
  for (std::size_t k = 0; k < 16; ++k) result[k] = u[k / 4] * v[k % 4];
  return result;
}

void set_row(Eigen::MatrixXd& matrix, int row, const std::array<double, 16>& values) {
  for (int k = 0; k < 16; ++k) matrix(row, k) = values[std::size_t(k)];
}

Samples make_samples(int rows, int columns) {
  const int count = rows * columns;
  Samples s{Eigen::MatrixXd(count, 16), Eigen::MatrixXd(count, 16), Eigen::MatrixXd(count, 16)};
  int at = 0;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column, ++at) {
      const double u = (row + 0.5) / rows, v = (column + 0.5) / columns;
      set_row(s.at, at, products(hermite_basis(u), hermite_basis(v)));
      set_row(s.by_u, at, products(hermite_derivative(u), hermite_basis(v)));
      set_row(s.by_v, at, products(hermite_basis(u), hermite_derivative(v)));
    }
  return s;
}

}  // namespace

std::array<double, 16> basis_products(double u, double v) {
  return products(hermite_basis(u), hermite_basis(v));
}

const Samples& samples_of(int rows, int columns) {
  using Made = std::array<std::unique_ptr<Samples>, std::size_t(most_samples) * most_samples>;
  Made& made = per_thread<Made>();
  auto& place = made[std::size_t(rows - 1) * most_samples + std::size_t(columns - 1)];
  if (!place) place = std::make_unique<Samples>(make_samples(rows, columns));
  return *place;
}

}  // namespace gradmesh
