#include "geom/patch.h"

#include "geom/hermite.h"

namespace gradmesh {
namespace {

// Position of corner k in the control matrix, as (row, column) in {0, 3}.
constexpr int corner_row[4] = {0, 0, 3, 3};
constexpr int corner_column[4] = {0, 3, 3, 0};
// Sign of the mixed derivative in the corner's local axes against that of (u, v).
constexpr double twist_sign[4] = {1, -1, 1, -1};

constexpr int twist_index(int end) { return end == 0 ? 1 : 2; }

using Basis = std::array<double, 4>;

/// Applies `convert`, which gives a cubic's coefficients in another form, along v and then along u.
template <class Convert>
BezierNet converted(BezierNet net, const Convert& convert) {
  for (std::array<Value, 4>& row : net) row = convert(row);
  for (int j = 0; j < 4; ++j) {
    const std::array<Value, 4> column = convert({net[0][j], net[1][j], net[2][j], net[3][j]});
    for (int i = 0; i < 4; ++i) net[i][j] = column[i];
  }
  return net;
}

Value blend(const Patch& patch, const Basis& bu, const Basis& bv) {
  Value sum;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) sum += patch.c[i][j] * (bu[i] * bv[j]);
  return sum;
}

}  // namespace

Value Patch::at(double u, double v) const {
  return blend(*this, hermite_basis(u), hermite_basis(v));
}

Value Patch::derivative_u(double u, double v) const {
  return blend(*this, hermite_derivative(u), hermite_basis(v));
}

Value Patch::derivative_v(double u, double v) const {
  return blend(*this, hermite_basis(u), hermite_derivative(v));
}

Value Patch::corner(int k) const { return c[corner_row[k]][corner_column[k]]; }

Cubic<Value> Patch::side(int k) const {
  switch (k) {
    case 0:
      return {c[0][0], c[0][1], c[0][2], c[0][3]};
    case 1:
      return {c[0][3], c[1][3], c[2][3], c[3][3]};
    case 2:
      return Cubic<Value>{c[3][0], c[3][1], c[3][2], c[3][3]}.reversed();
    default:
      return Cubic<Value>{c[0][0], c[1][0], c[2][0], c[3][0]}.reversed();
  }
}

Value Patch::twist(int k) const {
  return c[twist_index(corner_row[k])][twist_index(corner_column[k])] * twist_sign[k];
}

Patch Patch::part_v(double a, double b) const {
  Patch part;
  for (int i = 0; i < 4; ++i) {
    // Row i is a cubic in v: of values for i = 0, 3 and of u-derivatives for i = 1, 2.
    const Cubic<Value> row = Cubic<Value>{c[i][0], c[i][1], c[i][2], c[i][3]}.part(a, b);
    part.c[i] = {row.p0, row.m0, row.m1, row.p1};
  }
  return part;
}

Patch Patch::part_u(double a, double b) const {
  Patch part;
  for (int j = 0; j < 4; ++j) {
    const Cubic<Value> column = Cubic<Value>{c[0][j], c[1][j], c[2][j], c[3][j]}.part(a, b);
    part.c[0][j] = column.p0;
    part.c[1][j] = column.m0;
    part.c[2][j] = column.m1;
    part.c[3][j] = column.p1;
  }
  return part;
}

std::array<Patch, 2> Patch::split_u(double t) const { return {part_u(0, t), part_u(t, 1)}; }
std::array<Patch, 2> Patch::split_v(double t) const { return {part_v(0, t), part_v(t, 1)}; }

Patch patch_from_sides(const std::array<Cubic<Value>, 4>& sides,
                       const std::array<Value, 4>& twists) {
  Patch patch;
  const Cubic<Value>&top = sides[0], &right = sides[1];
  const Cubic<Value> bottom = sides[2].reversed(), left = sides[3].reversed();
  patch.c[0] = {top.p0, top.m0, top.m1, top.p1};
  patch.c[3] = {bottom.p0, bottom.m0, bottom.m1, bottom.p1};
  patch.c[1][0] = left.m0;
  patch.c[2][0] = left.m1;
  patch.c[1][3] = right.m0;
  patch.c[2][3] = right.m1;
  for (int k = 0; k < 4; ++k)
    patch.c[twist_index(corner_row[k])][twist_index(corner_column[k])] = twists[k] * twist_sign[k];
  return patch;
}

BezierNet bezier_net(const Patch& patch) {
  const auto convert = [](const std::array<Value, 4>& h) -> std::array<Value, 4> {
    const Cubic<Value> curve{h[0], h[1], h[2], h[3]};
    return {curve.p0, curve.bezier1(), curve.bezier2(), curve.p1};
  };
  return converted(patch.c, convert);
}

Patch patch_from_bezier(const BezierNet& net) {
  const auto convert = [](const std::array<Value, 4>& b) -> std::array<Value, 4> {
    const Cubic<Value> curve = Cubic<Value>::from_bezier(b[0], b[1], b[2], b[3]);
    return {curve.p0, curve.m0, curve.m1, curve.p1};
  };
  return {converted(net, convert)};
}

std::array<std::array<glm::dvec2, 2>, 2> coons_interior(const BezierNet& net) {
  std::array<std::array<glm::dvec2, 2>, 2> interior;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) {
      // p(i, j): the net seen from the corner that this interior point belongs to.
      const auto p = [&](int i, int j) { return net[a ? 3 - i : i][b ? 3 - j : j].position; };
      interior[a][b] = (-4.0 * p(0, 0) + 6.0 * (p(0, 1) + p(1, 0)) - 2.0 * (p(0, 3) + p(3, 0)) +
                        3.0 * (p(3, 1) + p(1, 3)) - p(3, 3)) /
                       9.0;
    }
  return interior;
}

void make_coons(Patch& patch) {
  BezierNet net = bezier_net(patch);
  const auto coons = coons_interior(net);
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) net[1 + a][1 + b].position = coons[a][b];
  const Patch made = patch_from_bezier(net);
  // Only the twists follow from the interior points: the sides stay to the last bit.
  for (int i : {1, 2})
    for (int j : {1, 2}) patch.c[i][j].position = made.c[i][j].position;
}

void transform(Patch& patch, const Affine& affine) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      glm::dvec2& position = patch.c[i][j].position;
      const bool is_corner = i % 3 == 0 && j % 3 == 0;
      position = is_corner ? affine.point(position) : affine.vector(position);
    }
}

void make_color_bilinear(Patch& patch) {
  auto& c = patch.c;
  const glm::dvec4 c0 = c[0][0].color, c1 = c[3][0].color;
  const glm::dvec4 c2 = c[0][3].color, c3 = c[3][3].color;
  const glm::dvec4 twist = c0 - c1 - c2 + c3;
  for (int j : {1, 2}) {
    c[0][j].color = c2 - c0;
    c[3][j].color = c3 - c1;
  }
  for (int i : {1, 2}) {
    c[i][0].color = c1 - c0;
    c[i][3].color = c3 - c2;
    for (int j : {1, 2}) c[i][j].color = twist;
  }
}

}  // namespace gradmesh
