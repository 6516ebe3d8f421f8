#include "methods/plain/movers.h"

#include "geom/cubic.h"
#include "mesh/mesh.h"

namespace gradmesh {
namespace {

/// Returns a side of a patch, which runs clockwise: the bottom and the left against the grid, whose
/// tangents these are.
Cubic<Value> clockwise(int side, const glm::dvec2& from, const std::array<glm::dvec2, 2>& tangents,
                       const glm::dvec2& to) {
  Cubic<Value> curve;
  const bool runs_back = side >= 2;
  curve.p0.position = from;
  curve.m0.position = runs_back ? -tangents[1] : tangents[0];
  curve.m1.position = runs_back ? -tangents[0] : tangents[1];
  curve.p1.position = to;
  return curve;
}

/// The patch is linear in its movers, so each is tried with the length 1 along x.
Shares place_shares_of(int mover, int curves) {
  std::array<Cubic<Value>, 4> sides;
  const auto corner = [&](int k) { return glm::dvec2(k % 4 == mover ? 1 : 0, 0); };
  for (int k = 0; k < 4; ++k) {
    // As the grid has them: from left to right or from top to bottom.
    const glm::dvec2 chord = (k >= 2 ? -1.0 : 1.0) * (corner(k + 1) - corner(k));
    std::array<glm::dvec2, 2> tangents = {chord, chord};
    if ((curves >> k & 1) != 0)
      for (int end = 0; end < 2; ++end)
        tangents[std::size_t(end)] = glm::dvec2(mover == tangent_mover(k, end) ? 1 : 0, 0);
    sides[std::size_t(k)] = clockwise(k, corner(k), tangents, corner(k + 1));
  }
  Patch patch = patch_from_sides(sides, {});
  make_coons(patch);
  Shares shares;
  for (std::size_t c = 0; c < 16; ++c) shares[c] = patch.c[c / 4][c % 4].position.x;
  return shares;
}

Shares color_shares_of(int mover) {
  std::array<Cubic<Value>, 4> sides;
  for (int k = 0; k < 4; ++k) {
    Cubic<Value>& side = sides[std::size_t(k)];
    side.p0.color = glm::dvec4(k == mover);
    side.p1.color = glm::dvec4((k + 1) % 4 == mover);
    side.m0.color = side.m1.color = side.p1.color - side.p0.color;
  }
  Patch patch = patch_from_sides(sides, {});
  make_coons(patch);
  make_color_bilinear(patch);
  Shares shares;
  for (std::size_t c = 0; c < 16; ++c) shares[c] = patch.c[c / 4][c % 4].color.x;
  return shares;
}

}  // namespace

const std::array<Shares, most_movers>& place_shares(int curves) {
  static const auto all = [] {
    std::array<std::array<Shares, most_movers>, 16> made;
    for (int c = 0; c < 16; ++c)
      for (int mover = 0; mover < most_movers; ++mover)
        made[std::size_t(c)][std::size_t(mover)] = place_shares_of(mover, c);
    return made;
  }();
  return all[std::size_t(curves)];
}

const std::array<Shares, corner_movers>& color_shares() {
  static const auto all = [] {
    std::array<Shares, corner_movers> made;
    for (int mover = 0; mover < corner_movers; ++mover)
      made[std::size_t(mover)] = color_shares_of(mover);
    return made;
  }();
  return all;
}

}  // namespace gradmesh
