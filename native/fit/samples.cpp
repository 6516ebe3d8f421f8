#include "fit/samples.h"

#include "geom/hermite.h"

namespace gradmesh {
namespace {

using Basis = std::array<double, 4>;
using AllParts = std::array<Parts, most_samples + 1>;

AllParts make_parts() {
  AllParts all;
  for (int count = 1; count <= most_samples; ++count) {
    Parts& parts = all[std::size_t(count)];
    parts.count = count;
    for (std::size_t part = 0; part < std::size_t(count); ++part) {
      const double t = (double(part) + 0.5) / count;
      const Basis at = hermite_basis(t), along = hermite_derivative(t);
      for (std::size_t k = 0; k < 4; ++k) {
        parts.at[k][part] = at[k];
        parts.along[k][part] = along[k];
      }
    }
  }
  return all;
}

}  // namespace

std::array<double, 16> basis_products(double u, double v) {
  const Basis by_u = hermite_basis(u), by_v = hermite_basis(v);
  std::array<double, 16> result;
  for (std::size_t k = 0; k < 16; ++k) result[k] = by_u[k / 4] * by_v[k % 4];
  return result;
}

const Parts& parts_of(int count) {
  static const AllParts all = make_parts();
  return all[std::size_t(count)];
}

void sum_up(const std::array<double, 16>& control, const Parts::Values& u, int rows,
            const Parts::Values& v, int columns, double* values) {
  for (std::size_t row = 0; row < std::size_t(rows); ++row) {
    std::array<double, 4> c;
    for (std::size_t j = 0; j < 4; ++j)
      c[j] = (u[0][row] * control[j] + u[1][row] * control[4 + j]) +
             (u[2][row] * control[8 + j] + u[3][row] * control[12 + j]);
    for (std::size_t column = 0; column < std::size_t(columns); ++column)
      values[column] =
          (v[0][column] * c[0] + v[1][column] * c[1]) + (v[2][column] * c[2] + v[3][column] * c[3]);
    values += columns;
  }
}

}  // namespace gradmesh
