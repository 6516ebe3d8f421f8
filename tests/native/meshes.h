#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "mesh/build.h"
#include "mesh/mesh.h"

namespace gradmesh::test {

/// A patch with straight sides and bilinear colours; corners clockwise from the top left.
inline Patch straight_patch(const std::array<Value, 4>& corners) {
  std::array<Cubic<Value>, 4> sides;
  for (int k = 0; k < 4; ++k) {
    const Value a = corners[k], b = corners[(k + 1) % 4];
    sides[k] = {a, b - a, b - a, b};
  }
  const Value twist = corners[0] - corners[1] + corners[2] - corners[3];
  return patch_from_sides(sides, {twist, -twist, twist, -twist});
}

struct GridOptions {
  int rows = 3, columns = 3;
  /// How far points and handles are moved at random, as a share of a patch's side.
  double position_noise = 0;
  double color_noise = 0;
  ColorModel color_model = ColorModel::bilinear;
};

/// A grid of 100 x 100 units a patch, with corners, handles and colours moved at random but
/// shared between neighbours.
inline MeshParts grid_parts(const GridOptions& options, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  // Braces, unlike parentheses, keep the order in which numbers are drawn.
  const auto shake = [&](double by) { return 100 * by * glm::dvec2{unit(random), unit(random)}; };
  const int rows = options.rows, columns = options.columns;
  std::vector<Value> corners;
  for (int i = 0; i <= rows; ++i)
    for (int j = 0; j <= columns; ++j) {
      const double a = double(i) / rows, b = double(j) / columns;
      glm::dvec4 color(0.2 + 0.5 * a, 0.8 - 0.6 * b, 0.3 + 0.4 * a * b, 1);
      for (int k = 0; k < 3; ++k)
        color[k] = std::clamp(color[k] + options.color_noise * unit(random), 0.0, 1.0);
      corners.push_back({glm::dvec2(100 * j, 100 * i) + shake(options.position_noise), color});
    }
  const auto corner = [&](int i, int j) { return corners[i * (columns + 1) + j]; };
  const auto curve = [&](const Value& a, const Value& b) {
    Cubic<Value> c{a, b - a, b - a, b};
    c.m0.position += shake(options.position_noise);
    c.m1.position += shake(options.position_noise);
    return c;
  };
  std::vector<Cubic<Value>> across, down;
  for (int i = 0; i <= rows; ++i)
    for (int j = 0; j < columns; ++j) across.push_back(curve(corner(i, j), corner(i, j + 1)));
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j <= columns; ++j) down.push_back(curve(corner(i, j), corner(i + 1, j)));

  MeshParts parts;
  parts.color_model = options.color_model;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const std::array<Cubic<Value>, 4> sides{
          across[i * columns + j], down[i * (columns + 1) + j + 1],
          across[(i + 1) * columns + j].reversed(), down[i * (columns + 1) + j].reversed()};
      const Value t = corner(i, j) - corner(i, j + 1) + corner(i + 1, j + 1) - corner(i + 1, j);
      std::array<Value, 4> twists{t, -t, t, -t};
      for (Value& twist : twists) twist.position += shake(options.position_noise);
      Patch patch = patch_from_sides(sides, twists);
      if (options.color_model == ColorModel::bilinear) make_color_bilinear(patch);
      parts.patches.push_back(patch);
    }
  parts.curves = grid_curves(rows, columns);
  return parts;
}

inline MeshParts grid_parts(const GridOptions& options, unsigned seed = 1) {
  std::mt19937 random(seed);
  return grid_parts(options, random);
}

inline Mesh grid_mesh(const GridOptions& options = {}, unsigned seed = 1) {
  return build_mesh(grid_parts(options, seed));
}

/// One `bicubic` patch cut exactly between these parameters, which rise from 0 to 1: a row of
/// patches for each two of `u`.
inline MeshParts cut_patch(const Patch& whole, const std::vector<double>& u,
                           const std::vector<double>& v) {
  MeshParts parts;
  parts.color_model = ColorModel::bicubic;
  for (std::size_t i = 0; i + 1 < u.size(); ++i)
    for (std::size_t j = 0; j + 1 < v.size(); ++j)
      parts.patches.push_back(whole.part_u(u[i], u[i + 1]).part_v(v[j], v[j + 1]));
  parts.curves = grid_curves(int(u.size()) - 1, int(v.size()) - 1);
  return parts;
}

/// All patches, in the order of the faces.
inline std::vector<Patch> patches(const Mesh& mesh) {
  std::vector<Patch> list;
  for (const Face f : mesh.faces()) list.push_back(mesh.patch(f));
  return list;
}

/// Largest distance between two patches' control vectors, positions in units of the mesh.
inline double difference(const Patch& a, const Patch& b) {
  double most = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const Value d = a.c[i][j] - b.c[i][j];
      for (const double x :
           {d.position.x, d.position.y, d.color.r, d.color.g, d.color.b, d.color.a})
        most = std::max(most, std::abs(x));
    }
  return most;
}

/// The half-edge between two faces, in the loop of the first; invalid where there is none.
inline Halfedge between(const Mesh& mesh, Face a, Face b) {
  for (const Halfedge h : mesh.sides(a)) {
    const Halfedge twin = mesh.other_side(h);
    if (twin.valid() && mesh.is_leaf(twin) && mesh.face(twin) == b) return h;
  }
  return {};
}

}  // namespace gradmesh::test
