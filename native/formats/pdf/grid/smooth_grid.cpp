#include "formats/pdf/grid/smooth_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "form/smooth_colors.h"
#include "formats/pdf/grid/joined_curves.h"

namespace gradmesh {
namespace {

/// The number of parts each way into which Inkscape divides a patch.
constexpr int parts_per_side = 8;
constexpr std::array<double, parts_per_side + 1> eighths{
    0, 1.0 / 8, 2.0 / 8, 3.0 / 8, 4.0 / 8, 5.0 / 8, 6.0 / 8, 7.0 / 8, 1};

using PartRows = std::array<ControlRow, parts_per_side>;

/// Joins rows of parts, unless one of them is off by more than what rounds them.
std::optional<ControlRow> whole_of_eighths(const PartRows& rows) {
  // Inkscape writes about 1e-7 pt, Ghostscript 1/512 of one.
  constexpr double tolerance = 0.005;
  std::array<CurvePart, parts_per_side> parts{};
  for (std::size_t n = 0; n < rows.size(); ++n) parts[n] = {rows[n], eighths[n], eighths[n + 1]};
  const ControlRow whole = closest_whole(parts);
  if (deviation(whole, parts) > tolerance) return {};
  return whole;
}

class PaintedGrid {
 public:
  explicit PaintedGrid(const ArtistsGrid& painted) : painted_(painted) {}

  int rows() const { return painted_.rows / parts_per_side; }
  int columns() const { return painted_.columns / parts_per_side; }

  /// Returns the patch of which 8 x 8 are the parts, if they are.
  std::optional<PagePatch> whole(int row, int column) const {
    // Columns of the control points, by the parts' rows.
    std::array<PartRows, 4> down{};
    for (std::size_t part = 0; part < parts_per_side; ++part)
      for (std::size_t i = 0; i < 4; ++i) {
        PartRows across{};
        for (std::size_t n = 0; n < parts_per_side; ++n)
          across[n] = part_at(row, column, int(part), int(n)).net()[i];
        const auto joined = whole_of_eighths(across);
        if (!joined) return {};
        for (std::size_t j = 0; j < 4; ++j) down[j][part][i] = (*joined)[j];
      }
    std::array<ControlRow, 4> net{};
    for (std::size_t j = 0; j < 4; ++j) {
      const auto joined = whole_of_eighths(down[j]);
      if (!joined) return {};
      for (std::size_t i = 0; i < 4; ++i) net[i][j] = (*joined)[i];
    }
    constexpr int last = parts_per_side - 1;
    PagePatch patch;
    patch.set_net(net);
    patch.colors = {part_at(row, column, 0, 0).colors[0], part_at(row, column, 0, last).colors[1],
                    part_at(row, column, last, last).colors[2],
                    part_at(row, column, last, 0).colors[3]};
    return patch;
  }

  /// Returns whether the parts of a patch are as Inkscape paints this one.
  bool has_colors_of(const Patch& patch, int row, int column) const {
    constexpr double hardly = 1.5 / 255;
    for (int i = 0; i < parts_per_side; ++i)
      for (int j = 0; j < parts_per_side; ++j)
        for (std::size_t k = 0; k < 4; ++k) {
          const int down = i + (k > 1), right = j + (k == 1 || k == 2);
          const glm::dvec4 smooth =
              patch.at(eighths[std::size_t(down)], eighths[std::size_t(right)]).color;
          const glm::dvec4 off =
              part_at(row, column, i, j).colors[k] - glm::clamp(smooth, 0.0, 1.0);
          for (int c = 0; c < 4; ++c)
            if (std::abs(off[c]) > hardly) return false;
        }
    return true;
  }

 private:
  const PagePatch& part_at(int row, int column, int i, int j) const {
    const int down = parts_per_side * row + i, right = parts_per_side * column + j;
    return painted_.patches[std::size_t(down * painted_.columns + right)];
  }

  const ArtistsGrid& painted_;
};

SmoothColors colors_of(const ArtistsGrid& grid) {
  std::vector<SmoothColors::Corner> corners;
  for (int i = 0; i <= grid.rows; ++i)
    for (int j = 0; j <= grid.columns; ++j) {
      const bool below = i == grid.rows, beside = j == grid.columns;
      const PagePatch& patch = grid.patches[std::size_t((i - below) * grid.columns + j - beside)];
      const std::size_t k = below ? (beside ? 2 : 3) : (beside ? 1 : 0);
      corners.push_back({patch.outer[3 * k], glm::dvec3(patch.colors[k])});
    }
  return SmoothColors(grid.rows, grid.columns, corners);
}

}  // namespace

ArtistsGrid as_it_is(const PageGrid& grid, const PatchSides& sides) {
  ArtistsGrid found{grid.rows, grid.columns, {}};
  for (const LaidPatch& lies : grid.patches)
    found.patches.push_back(laid(sides.patches()[std::size_t(lies.patch)], lies));
  return found;
}

std::optional<ArtistsGrid> smooth_grid(const ArtistsGrid& painted) {
  if (painted.rows % parts_per_side != 0 || painted.columns % parts_per_side != 0) return {};
  const PaintedGrid parts(painted);
  ArtistsGrid grid{parts.rows(), parts.columns(), {}, true};
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const auto whole = parts.whole(row, column);
      if (!whole) return {};
      grid.patches.push_back(*whole);
    }
  const SmoothColors colors = colors_of(grid);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      Patch patch = mesh_patch(grid.patches[std::size_t(row * grid.columns + column)]);
      colors.apply(patch, row, column);
      if (!parts.has_colors_of(patch, row, column)) return {};
    }
  return grid;
}

}  // namespace gradmesh
