#include "methods/plain/side_rises.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "methods/plain/grid_fit.h"

namespace gradmesh {
namespace {

/// Returns the patches beside a side.
std::vector<PatchPlace> patches_beside(const PlainGrid& grid, const Side& side) {
  const int above = side.along == Along::rows, left = side.along == Along::columns;
  std::vector<PatchPlace> places;
  for (const auto& [i, j] :
       {PatchPlace{side.row, side.column}, PatchPlace{side.row - above, side.column - left}})
    if (i >= 0 && j >= 0 && i < grid.rows() && j < grid.columns()) places.push_back({i, j});
  return places;
}

}  // namespace

std::vector<double> rises_if_straight(const PlainGrid& grid, const std::vector<Side>& sides,
                                      const Reference& target) {
  std::vector<PatchPlace> patches;
  for (const Side& side : sides)
    for (const PatchPlace& place : patches_beside(grid, side)) patches.push_back(place);
  std::ranges::sort(patches);
  patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
  std::vector<double> squares(patches.size());
  const PaintedGrid painted(grid);
  parallel_for(patches.size(), [&](std::size_t n) {
    squares[n] = patch_squares(painted, patches[n].row, patches[n].column, target);
  });

  std::vector<double> rises(sides.size(), 0);
  // A copy of the grid for each thread.
  const std::size_t shares = std::min(thread_count(), sides.size());
  parallel_for(shares, [&](std::size_t share) {
    PlainGrid straight = grid;
    // Sides that become straight change no colours.
    const PaintedGrid painted_straight(straight);
    for (std::size_t n = share; n < sides.size(); n += shares) {
      const Side& side = sides[n];
      PlainGrid::Bend& bend = straight.bend(side.along, side.row, side.column);
      const PlainGrid::Bend curve = std::exchange(bend, std::nullopt);
      for (const PatchPlace& place : patches_beside(grid, side)) {
        const auto known = std::ranges::lower_bound(patches, place) - patches.begin();
        rises[n] += patch_squares(painted_straight, place.row, place.column, target) -
                    squares[std::size_t(known)];
      }
      bend = curve;
    }
  });
  return rises;
}

}  // namespace gradmesh
