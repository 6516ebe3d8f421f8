#include "block_mesh.h"

#include <cmath>

#include "mesh/build.h"

namespace gradmesh::bench {
namespace {

constexpr double block_size = 125;

/// Waves of a few blocks' length, in colour and, for the corners of blocks, in position.
glm::dvec4 color_at(glm::dvec2 p) {
  const auto wave = [&](double x, double y) {
    return 0.5 + 0.4 * std::sin(p.x / x) * std::cos(p.y / y);
  };
  return {wave(180, 260), wave(280, 160), wave(220, 340), 1};
}

Value corner(int i, int j) {
  return {glm::dvec2(block_size * j + 15 * std::sin(2.1 * i + j),
                     block_size * i + 15 * std::cos(1.7 * j - i)),
          glm::dvec4(0)};
}

/// From one corner of blocks to the next, with handles that let it bend.
Cubic<Value> curve(const Value& a, const Value& b) {
  const Value chord = b - a;
  const glm::dvec2 aside(-chord.position.y, chord.position.x);
  Cubic<Value> c{a, chord, chord, b};
  c.m0.position += 0.2 * aside;
  c.m1.position -= 0.2 * aside;
  return c;
}

Patch block(int i, int j) {
  const Value corners[] = {corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)};
  const Value twist = corners[0] - corners[1] + corners[2] - corners[3];
  return patch_from_sides(
      {curve(corners[0], corners[1]), curve(corners[1], corners[2]),
       curve(corners[3], corners[2]).reversed(), curve(corners[0], corners[3]).reversed()},
      {twist, -twist, twist, -twist});
}

MeshParts block_parts(const Patch& whole) {
  MeshParts parts{{}, grid_curves(block_side, block_side)};
  const auto at = [](int k) { return double(k) / block_side; };
  for (int i = 0; i < block_side; ++i) {
    const Patch row = whole.part_u(at(i), at(i + 1));
    for (int j = 0; j < block_side; ++j) {
      Patch patch = row.part_v(at(j), at(j + 1));
      for (Value* v : {&patch.c[0][0], &patch.c[0][3], &patch.c[3][0], &patch.c[3][3]})
        v->color = color_at(v->position);
      make_color_bilinear(patch);
      parts.patches.push_back(patch);
    }
  }
  return parts;
}

/// The half-edges along a side of a block, clockwise.
CurveSide block_side_of(int block, int side) {
  CurveSide result;
  for (int k = 0; k < block_side; ++k) {
    const int last = block_side - 1;
    const int row = side == 0 ? 0 : side == 1 ? k : side == 2 ? last : last - k;
    const int column = side == 0 ? k : side == 1 ? last : side == 2 ? last - k : 0;
    result.halfedges.push_back(4 * ((block * block_side + row) * block_side + column) + side);
    if (k > 0) result.breaks.push_back(double(k) / block_side);
  }
  return result;
}

}  // namespace

Mesh block_mesh(int blocks) {
  MeshParts parts;
  for (int i = 0; i < blocks; ++i)
    for (int j = 0; j < blocks; ++j) {
      const int number = i * blocks + j;
      append(parts, block_parts(block(i, j)));
      if (j + 1 < blocks)
        parts.curves.push_back({block_side_of(number, 1), block_side_of(number + 1, 3)});
      if (i + 1 < blocks)
        parts.curves.push_back({block_side_of(number, 2), block_side_of(number + blocks, 0)});
    }
  return build_mesh(parts);
}

}  // namespace gradmesh::bench
