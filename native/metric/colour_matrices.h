#pragma once

#include <array>

namespace gradmesh {

// Colours of FLIP: linear RGB, CIE XYZ, and opponent colours, which are FLIP's YCxCz but for
// constant factors.

using Matrix = std::array<std::array<double, 3>, 3>;

constexpr Matrix operator*(const Matrix& a, const Matrix& b) {
  Matrix product{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) product[i][j] += a[i][k] * b[k][j];
  return product;
}

/// The same matrix in float, to multiply samples with.
struct Linear {
  std::array<std::array<float, 3>, 3> m{};

  explicit constexpr Linear(const Matrix& matrix) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) m[i][j] = float(matrix[i][j]);
  }
};

inline constexpr double white_x = 0.950428545, white_z = 1.088900371;  // D65, Y = 1
inline constexpr Matrix rgb_to_xyz = {
    {{10135552 / 24577794.0, 8788810 / 24577794.0, 4435075 / 24577794.0},
     {2613072 / 12288897.0, 8788810 / 12288897.0, 887015 / 12288897.0},
     {1425312 / 73733382.0, 8788810 / 73733382.0, 70074185 / 73733382.0}}};
inline constexpr Matrix xyz_to_rgb = {{{3.241003275, -1.537398934, -0.498615861},
                                       {-0.969224334, 1.875930071, 0.041554224},
                                       {0.055639423, -0.204011202, 1.057148933}}};
inline constexpr Matrix over_white = {{{1 / white_x, 0, 0}, {0, 1, 0}, {0, 0, 1 / white_z}}};
inline constexpr Matrix times_white = {{{white_x, 0, 0}, {0, 1, 0}, {0, 0, white_z}}};
/// Map (x, y, z) over white to (y, x - y, y - z) and back.
inline constexpr Matrix to_opponent = {{{0, 1, 0}, {1, -1, 0}, {0, 1, -1}}};
inline constexpr Matrix from_opponent = {{{1, 1, 0}, {1, 0, 0}, {1, 0, -1}}};

inline constexpr Linear rgb_to_white_xyz(over_white* rgb_to_xyz);
inline constexpr Linear rgb_to_opponent(to_opponent* over_white* rgb_to_xyz);
inline constexpr Linear opponent_to_rgb(xyz_to_rgb* times_white* from_opponent);

}  // namespace gradmesh
