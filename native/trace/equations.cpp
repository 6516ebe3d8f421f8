#include "trace/equations.h"

#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "trace/patch_sums.h"

namespace gradmesh {
namespace {

ColoredQuad patch_of(const LineGrid& grid, const std::array<int, 4>& corners,
                     const TargetPicture& target) {
  const glm::dvec2 scale = pixels_per_unit(grid, target);
  ColoredQuad patch;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    patch.places[k] = scale * grid.knot(corners[k]).position;
    patch.colors[k] = grid.knot(corners[k]).color;
  }
  return patch;
}

/// What an unknown of a patch is: which corner's, and of which channel, or its place along a way.
struct PatchUnknown {
  std::size_t corner;
  /// The channel, or -1 for the place.
  int channel;
  int column;
  glm::dvec2 way{0.0};

  bool is_place() const { return channel < 0; }
};

std::vector<PatchUnknown> unknowns_of(const LineGrid& grid, const std::array<int, 4>& corners,
                                      glm::dvec2 scale, const GridColumns& columns,
                                      int channel_count) {
  std::vector<PatchUnknown> unknowns;
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    const KnotColumns& of = columns.of(corners[corner]);
    for (std::size_t way = 0; way < of.place.size(); ++way)
      if (of.place[way] >= 0)
        unknowns.push_back(
            {corner, -1, of.place[way], way_in_pixels(grid.knot(corners[corner]), way, scale)});
    for (int k = 0; of.color >= 0 && k < channel_count; ++k)
      unknowns.push_back({corner, k, of.color + k});
  }
  return unknowns;
}

double coefficient(const PatchSums& sums, const PatchUnknown& p, const PatchUnknown& q) {
  const std::size_t pair = PatchSums::pair(p.corner, q.corner);
  if (p.is_place() && q.is_place())
    return p.way.x * q.way.x * sums.place[0][pair] + p.way.y * q.way.y * sums.place[2][pair] +
           (p.way.x * q.way.y + p.way.y * q.way.x) * sums.place[1][pair];
  if (p.is_place() || q.is_place()) {
    const PatchUnknown &place = p.is_place() ? p : q, &color = p.is_place() ? q : p;
    const auto& both = sums.both[std::size_t(color.channel)];
    return place.way.x * both[0][pair] + place.way.y * both[1][pair];
  }
  if (p.channel != q.channel) return 0;
  return p.channel == 3 ? sums.opacity[pair] : sums.color[pair];
}

double right_hand_side(const PatchSums& sums, const PatchUnknown& p) {
  return p.is_place()
             ? p.way.x * sums.place_rhs[0][p.corner] + p.way.y * sums.place_rhs[1][p.corner]
             : sums.color_rhs[std::size_t(p.channel)][p.corner];
}

}  // namespace

GridColumns::GridColumns(const LineGrid& grid, const TargetPicture& target, Along along, int first,
                         int last)
    : columns_(std::size_t(grid.points())) {
  for (int row = 0; row <= grid.rows(); ++row)
    for (int column = 0; column <= grid.columns(); ++column) {
      const int line = along == Along::rows ? row : column, number = grid.number(row, column);
      if (line < first || line > last) continue;
      KnotColumns& of = columns_[std::size_t(number)];
      for (int way = 0; way < grid.knot(number).ways; ++way) of.place[std::size_t(way)] = count_++;
      of.color = count_;
      count_ += channels(target);
    }
}

glm::dvec2 pixels_per_unit(const LineGrid& grid, const TargetPicture& target) {
  return glm::dvec2(target.width, target.height) / grid.size();
}

glm::dvec2 way_in_pixels(const LineGrid::Knot& knot, std::size_t way, glm::dvec2 pixels_per_unit) {
  return glm::normalize(pixels_per_unit * knot.way[way]);
}

double patch_squares(const LineGrid& grid, int row, int column, const TargetPicture& target) {
  const ColoredQuad patch = patch_of(grid, grid.corners(row, column), target);
  const PatchSums sums = patch_sums(patch, target, Asked::squares);
  return std::accumulate(sums.squares.begin(), sums.squares.end(), 0.0);
}

NormalEquations patch_equations(const LineGrid& grid, int row, int column,
                                const TargetPicture& target, const GridColumns& columns) {
  const std::array<int, 4> corners = grid.corners(row, column);
  const PatchSums sums = patch_sums(patch_of(grid, corners, target), target, Asked::all);
  const std::vector<PatchUnknown> unknowns =
      unknowns_of(grid, corners, pixels_per_unit(grid, target), columns, channels(target));
  const auto size = Eigen::Index(unknowns.size());
  NormalEquations equations{{},
                            Eigen::MatrixXd(size, size),
                            Eigen::VectorXd(size),
                            std::accumulate(sums.squares.begin(), sums.squares.end(), 0.0)};
  for (Eigen::Index a = 0; a < size; ++a) {
    const PatchUnknown& unknown = unknowns[std::size_t(a)];
    equations.columns.push_back(unknown.column);
    equations.rhs(a) = right_hand_side(sums, unknown);
    for (Eigen::Index b = 0; b < size; ++b)
      equations.matrix(a, b) = coefficient(sums, unknown, unknowns[std::size_t(b)]);
  }
  return equations;
}

std::vector<NormalEquations> channel_equations(const LineGrid& grid, int row, int column,
                                               const TargetPicture& target) {
  const std::array<int, 4> corners = grid.corners(row, column);
  const PatchSums sums = patch_sums(patch_of(grid, corners, target), target, Asked::colors);
  std::vector<NormalEquations> equations;
  for (std::size_t k = 0; k < std::size_t(channels(target)); ++k) {
    Eigen::MatrixXd matrix(4, 4);
    for (std::size_t a = 0; a < corners.size(); ++a)
      for (std::size_t b = 0; b < corners.size(); ++b)
        matrix(Eigen::Index(a), Eigen::Index(b)) =
            (k == 3 ? sums.opacity : sums.color)[PatchSums::pair(a, b)];
    equations.push_back({{corners.begin(), corners.end()},
                         std::move(matrix),
                         Eigen::Map<const Eigen::Vector4d>(sums.color_rhs[k].data()),
                         sums.squares[k]});
  }
  return equations;
}

}  // namespace gradmesh
