#pragma once

#include <array>

namespace gradmesh {

/// The sixteen coefficients of a bicubic in (u, v), the first index along u: those of the Hermite
/// matrix of Patch, Bezier points, or of u^i v^j.
template <class V>
using Bicubic = std::array<std::array<V, 4>, 4>;

/// Matrices that take the Hermite form of a cubic (p0, m0, m1, p1) to its powers (the paper's B,
/// Eq. 2) and to its Bezier points.
constexpr double powers_of_hermite[4][4] = {
    {1, 0, 0, 0}, {0, 1, 0, 0}, {-3, -2, -1, 3}, {2, 1, 1, -2}};
constexpr double bezier_of_hermite[4][4] = {
    {1, 0, 0, 0}, {1, 1.0 / 3, 0, 0}, {0, 0, -1.0 / 3, 1}, {0, 0, 0, 1}};

/// Returns the same bicubic in another form, by one of the tables above.
template <class V>
Bicubic<V> change_form(const Bicubic<V>& from, const double (&table)[4][4]) {
  const auto sum = [&](const double(&row)[4], const V& a, const V& b, const V& c, const V& d) {
    return ((row[0] * a + row[1] * b) + row[2] * c) + row[3] * d;
  };
  Bicubic<V> half, to;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      half[i][j] = sum(table[j], from[i][0], from[i][1], from[i][2], from[i][3]);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      to[i][j] = sum(table[i], half[0][j], half[1][j], half[2][j], half[3][j]);
  return to;
}

}  // namespace gradmesh
