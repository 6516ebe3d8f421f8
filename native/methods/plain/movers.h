#pragma once

#include <array>

namespace gradmesh {

/// What moves a Coons patch of a grid: its corners and, for each side that is a curve, the tangents
/// of the grid's side at its two ends, in the grid's direction. Corner k comes first, then tangent
/// `tangent_mover(side, end)`.
inline constexpr int corner_movers = 4, most_movers = corner_movers + 8;

constexpr int tangent_mover(int side, int end) { return corner_movers + 2 * side + end; }

/// How the 16 control vectors of a patch change with a mover, row by row.
using Shares = std::array<double, 16>;

/// Returns how the places of the control vectors move with each mover. Bit k of `curves` says that
/// side k is a curve. Movers that the patch does not have have no shares.
const std::array<Shares, most_movers>& place_shares(int curves);

/// Returns how the colours of the control vectors follow the colour of each corner.
const std::array<Shares, corner_movers>& color_shares();

}  // namespace gradmesh
