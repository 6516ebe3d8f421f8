#include "raster/folds.h"

#include <algorithm>
#include <cmath>

#include "geom/cross.h"

namespace gradmesh {
namespace {

/// How small the Jacobian may be against its largest coefficient for Newton's method to be used.
constexpr double least_share = 1e-3;

/// A polynomial of degree 5 in u and in v, by its Bezier coefficients, between which it lies.
using Biquintic = std::array<std::array<double, 6>, 6>;

Biquintic jacobian_of(const Bicubic<glm::dvec2>& p) {
  constexpr double two[3] = {1, 2, 1}, three[4] = {1, 3, 3, 1}, five[6] = {1, 5, 10, 10, 5, 1};
  Biquintic jacobian = {};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) {
      const glm::dvec2 along_u = (two[i] * three[j]) * (p[i + 1][j] - p[i][j]);
      for (int k = 0; k < 4; ++k)
        for (int l = 0; l < 3; ++l)
          jacobian[i + k][j + l] += (three[k] * two[l]) * cross(along_u, p[k][l + 1] - p[k][l]);
    }
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) jacobian[i][j] /= five[i] * five[j];
  return jacobian;
}

/// Returns both halves of a polynomial, by de Casteljau's algorithm.
std::array<Biquintic, 2> halves_along_u(Biquintic p) {
  Biquintic first;
  for (int n = 0; n < 6; ++n) {
    first[n] = p[0];
    // What is done with is left at the end, which becomes the second half.
    for (int i = 0; i + n < 5; ++i)
      for (int j = 0; j < 6; ++j) p[i][j] = (p[i][j] + p[i + 1][j]) / 2;
  }
  return {first, p};
}

Biquintic transposed(const Biquintic& p) {
  Biquintic result;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) result[j][i] = p[i][j];
  return result;
}

struct Marker {
  double least;
  Folds folds;

  /// Marks `size` x `size` cells from (u, v) on, over which the Jacobian is `p`.
  void mark(const Biquintic& p, int u, int v, int size) {
    double low = INFINITY, high = -INFINITY;
    for (const auto& row : p)
      for (const double coefficient : row) {
        low = std::min(low, coefficient);
        high = std::max(high, coefficient);
      }
    const int sign = low > least ? 1 : high < -least ? -1 : 0;
    if (sign != 0 || size == 1) {
      for (int i = 0; i < size; ++i) std::fill_n(&folds.sign[u + i][v], size, std::int8_t(sign));
      return;
    }
    const int half = size / 2;
    const std::array<Biquintic, 2> along_u = halves_along_u(p);
    for (int i = 0; i < 2; ++i) {
      const std::array<Biquintic, 2> along_v = halves_along_u(transposed(along_u[i]));
      for (int j = 0; j < 2; ++j) mark(transposed(along_v[j]), u + i * half, v + j * half, half);
    }
  }
};

}  // namespace

Folds folds_of(const Bicubic<glm::dvec2>& bezier) {
  const Biquintic jacobian = jacobian_of(bezier);
  double most = 0;
  for (const auto& row : jacobian)
    for (const double coefficient : row) most = std::max(most, std::abs(coefficient));
  Marker marker{least_share * most, {}};
  marker.mark(jacobian, 0, 0, Folds::cells);
  return marker.folds;
}

bool may_fold(const Patch& patch) {
  const BezierNet net = bezier_net(patch);
  Bicubic<glm::dvec2> positions;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) positions[i][j] = net[i][j].position;
  return folds_of(positions).possible();
}

}  // namespace gradmesh
