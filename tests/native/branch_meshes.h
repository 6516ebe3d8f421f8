#pragma once

#include "meshes.h"

namespace gradmesh::test {

/// Small meshes whose topology is no rectangle (paper 4.4, Fig. 6, and appendix C). All have
/// straight sides, and colours that follow from the position, so that pictures have no seams.

inline Value colored(glm::dvec2 p) {
  return {p, {0.5 + 0.4 * std::sin(p.x), 0.5 + 0.4 * std::sin(p.y), 0.5, 1}};
}

/// Corners clockwise from the start of side 0.
inline Patch quad(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
  return straight_patch({colored(a), colored(b), colored(c), colored(d)});
}

/// The unit square whose top left corner is (x, y).
inline Patch square(double x, double y) {
  return quad({x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1});
}

/// The curve along which two sides of patches meet.
inline CurveParts joint(int patch_a, int side_a, int patch_b, int side_b) {
  return {{{4 * patch_a + side_a}, {}}, {{4 * patch_b + side_b}, {}}};
}

/// Three patches round the point (1, 1) of the boundary: 0 | 1 beside each other, 2 below 1.
inline MeshParts l_branch() {
  return {{square(0, 0), square(1, 0), square(1, 1)}, {joint(0, 1, 1, 3), joint(1, 2, 2, 0)}};
}

/// Four patches round the point (1, 1) of the boundary: as before, and 3 left of 2, which touches
/// 0 but is not joined with it.
inline MeshParts u_branch() {
  MeshParts parts = l_branch();
  parts.patches.push_back(square(0, 1));
  parts.curves.push_back(joint(2, 3, 3, 1));
  return parts;
}

/// A square with an arm of `length` patches at each side. Each corner of the square is a point of
/// the boundary with three faces.
inline MeshParts cross(int length) {
  MeshParts parts{{square(0, 0)}, {}};
  const glm::dvec2 steps[4] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  for (int side = 0; side < 4; ++side) {
    int before = 0;
    for (int i = 1; i <= length; ++i) {
      const glm::dvec2 at = double(i) * steps[side];
      const int patch = int(parts.patches.size());
      parts.patches.push_back(square(at.x, at.y));
      parts.curves.push_back(joint(before, side, patch, (side + 2) % 4));
      before = patch;
    }
  }
  return parts;
}

/// A closed ring of n patches between the radii 1 and 2; side 0 is outside. No patch has two
/// neighbouring sides on the boundary.
inline MeshParts ring(int n, glm::dvec2 center = {0, 0}) {
  const double turn = 6.283185307179586 / n;
  const auto at = [&](double k, double radius) {
    const double angle = (k - 0.5) * turn;
    return center + radius * glm::dvec2(std::cos(angle), std::sin(angle));
  };
  MeshParts parts;
  for (int i = 0; i < n; ++i) {
    parts.patches.push_back(quad(at(i, 2), at(i + 1, 2), at(i + 1, 1), at(i, 1)));
    parts.curves.push_back(joint(i, 1, (i + 1) % n, 3));
  }
  return parts;
}

/// Two rings of six patches with a strip of two between them: a tree without ends, so there is no
/// corner either. Where the strip starts, two points of the boundary have three faces each.
inline MeshParts dumbbell() {
  MeshParts parts = ring(6, {-4, 0});
  append(parts, ring(6, {4, 0}));
  // Patch 0 of the left ring faces right, patch 3 of the right one (9) faces left.
  const glm::dvec2 left_top = parts.patches[0].corner(0).position;
  const glm::dvec2 left_bottom = parts.patches[0].corner(1).position;
  const glm::dvec2 right_top = parts.patches[9].corner(1).position;
  const glm::dvec2 right_bottom = parts.patches[9].corner(0).position;
  const glm::dvec2 top = 0.5 * (left_top + right_top), bottom = 0.5 * (left_bottom + right_bottom);
  append(parts,
         {{quad(left_top, top, bottom, left_bottom), quad(top, right_top, right_bottom, bottom)},
          {joint(0, 1, 1, 3)}});
  parts.curves.push_back(joint(0, 0, 12, 3));
  parts.curves.push_back(joint(9, 0, 13, 1));
  return parts;
}

/// Two grids of 2 x 2 patches that do not touch.
inline MeshParts two_components() {
  MeshParts parts = grid_parts({.rows = 2, .columns = 2});
  MeshParts more = parts;
  for (Patch& patch : more.patches) transform(patch, Affine::translation({300, 0}));
  append(parts, more);
  return parts;
}

/// Five patches that hang on each other in a circle: four of two squares each round one square in
/// the middle, each long side ending inside the next one. It cannot be drawn (Fig. 5), and
/// build_mesh refuses it.
inline MeshParts pinwheel() {
  const auto box = [](double x0, double y0, double x1, double y1) {
    return quad({x0, y0}, {x1, y0}, {x1, y1}, {x0, y1});
  };
  const auto divided = [](int patch, int side, int first, int second) {
    return CurveParts{{{4 * patch + side}, {}}, {{first, second}, {0.5}}};
  };
  // The top, right, bottom and left patch, and that in the middle.
  return {{box(0, 0, 2, 1), box(2, 0, 3, 2), box(1, 2, 3, 3), box(0, 1, 1, 3), box(1, 1, 2, 2)},
          {divided(0, 2, 4 * 3 + 0, 4 * 4 + 0), divided(1, 3, 4 * 0 + 1, 4 * 4 + 1),
           divided(2, 0, 4 * 1 + 2, 4 * 4 + 2), divided(3, 1, 4 * 2 + 3, 4 * 4 + 3)}};
}

}  // namespace gradmesh::test
