#include "trace/equations.h"

#include <glm/geometric.hpp>

#include "geom/cross.h"
#include "trace/pixels.h"

namespace gradmesh {
namespace {

constexpr std::size_t corner_count = 4, most_channels = 4;
/// The number of pairs of corners.
constexpr std::size_t pairs = 10;

using Corners = std::array<double, corner_count>;

/// Returns how much each corner counts at a place of a patch.
Corners weights_at(glm::dvec2 at) {
  const double u = at.x, v = at.y;
  return {(1 - u) * (1 - v), (1 - u) * v, u * v, u * (1 - v)};
}

/// Calls `f(a, b, n)` for the n-th pair of corners, of which b is not the greater one.
template <class F>
void for_each_pair(const F& f) {
  std::size_t n = 0;
  for (std::size_t a = 0; a < corner_count; ++a)
    for (std::size_t b = 0; b <= a; ++b) f(a, b, n++);
}

/// The colours of a patch: a bilinear map as its places are.
class QuadColors {
 public:
  explicit QuadColors(const std::array<glm::dvec4, 4>& c)
      : start_(c[0]),
        along_v_(c[1] - c[0]),
        along_u_(c[3] - c[0]),
        both_(c[0] - c[1] + c[2] - c[3]) {}

  glm::dvec4 at(double u, double v) const { return start_ + u * by_u(v) + v * along_v_; }
  glm::dvec4 by_u(double v) const { return along_u_ + v * both_; }
  glm::dvec4 by_v(double u) const { return along_v_ + u * both_; }

 private:
  glm::dvec4 start_, along_v_, along_u_, both_;
};

/// A patch as the equations see it.
struct Surface {
  Quad quad;
  std::array<int, 4> corners;
  QuadColors colors;
};

Surface surface_of(const LineGrid& grid, int row, int column, const TargetPicture& target) {
  const std::array<int, 4> corners = grid.corners(row, column);
  const glm::dvec2 scale = pixels_per_unit(grid, target);
  Quad quad;
  std::array<glm::dvec4, 4> colors;
  for (std::size_t k = 0; k < corner_count; ++k) {
    quad[k] = scale * grid.knot(corners[k]).position;
    colors[k] = grid.knot(corners[k]).color;
  }
  return {quad, corners, QuadColors(colors)};
}

/// How much the channels of a pixel count that itself counts by its weight.
glm::dvec4 channel_weights(const glm::vec4& pixel, double weight) {
  const double color = weight * double(pixel.a) * double(pixel.a) / (255.0 * 255.0);
  return {color, color, color, weight};
}

/// Calls `f(weights of corners, weights of channels, difference, map of places, u, v)` at the
/// pixels of a surface.
template <class F>
void for_each_difference(const Surface& s, const TargetPicture& target, const F& f) {
  for_each_pixel(
      s.quad, target.width, target.height, target.point, [&](int x, int y, glm::dvec2 at) {
        const glm::vec4& wanted = target.at(x, y);
        const double weight = target.weight(x, y);
        if (weight == 0) return;
        f(at, channel_weights(wanted, weight), s.colors.at(at.x, at.y) - glm::dvec4(wanted));
      });
}

/// The sums over the pixels of a patch of which its equations consist; of pairs of corners those
/// of for_each_pair.
struct Sums {
  /// Colours by colours and opacity by opacity.
  std::array<double, pairs> color{}, opacity{};
  /// x by x, x by y, y by y.
  std::array<std::array<double, pairs>, 3> place{};
  /// By channel: x by it and y by it.
  std::array<std::array<std::array<double, pairs>, 2>, most_channels> both{};
  std::array<Corners, most_channels> color_rhs{};
  std::array<Corners, 2> place_rhs{};
  double squares = 0;
};

template <int Channels>
Sums sums_of(const Surface& s, const TargetPicture& target) {
  Sums sums;
  const QuadMap map(s.quad);
  for_each_difference(s, target, [&](glm::dvec2 at, glm::dvec4 weight, glm::dvec4 difference) {
    const double u = at.x, v = at.y;
    const Corners w = weights_at(at);
    const glm::dvec2 by_u = map.by_u(v), by_v = map.by_v(u);
    const glm::dvec4 color_by_u = s.colors.by_u(v), color_by_v = s.colors.by_v(u);
    const double size = cross(by_v, by_u);
    const double share = size > 1e-9 ? 1 / size : 0;
    double xx = 0, xy = 0, yy = 0;
    glm::dvec2 pull(0.0);
    std::array<glm::dvec2, Channels> slopes;
    for (int k = 0; k < Channels; ++k) {
      const glm::dvec2 slope = share * glm::dvec2(color_by_v[k] * by_u.y - color_by_u[k] * by_v.y,
                                                  color_by_u[k] * by_v.x - color_by_v[k] * by_u.x);
      const glm::dvec2 weighted = weight[k] * slope;
      xx += weighted.x * slope.x;
      xy += weighted.x * slope.y;
      yy += weighted.y * slope.y;
      pull += difference[k] * weighted;
      sums.squares += weight[k] * difference[k] * difference[k];
      slopes[std::size_t(k)] = weighted;
    }
    for (std::size_t a = 0; a < corner_count; ++a) {
      for (int k = 0; k < Channels; ++k)
        sums.color_rhs[std::size_t(k)][a] -= w[a] * weight[k] * difference[k];
      sums.place_rhs[0][a] += w[a] * pull.x;
      sums.place_rhs[1][a] += w[a] * pull.y;
    }
    for_each_pair([&](std::size_t a, std::size_t b, std::size_t n) {
      const double ww = w[a] * w[b];
      sums.color[n] += weight[0] * ww;
      if (Channels == 4) sums.opacity[n] += weight[3] * ww;
      sums.place[0][n] += xx * ww;
      sums.place[1][n] += xy * ww;
      sums.place[2][n] += yy * ww;
      for (int k = 0; k < Channels; ++k) {
        sums.both[std::size_t(k)][0][n] -= slopes[std::size_t(k)].x * ww;
        sums.both[std::size_t(k)][1][n] -= slopes[std::size_t(k)].y * ww;
      }
    });
  });
  return sums;
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
  for (std::size_t corner = 0; corner < corner_count; ++corner) {
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

double coefficient(const Sums& sums, const PatchUnknown& p, const PatchUnknown& q) {
  const std::size_t a = std::max(p.corner, q.corner), b = std::min(p.corner, q.corner);
  const std::size_t pair = a * (a + 1) / 2 + b;
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

double right_hand_side(const Sums& sums, const PatchUnknown& p) {
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
  double squares = 0;
  const int count = channels(target);
  for_each_difference(surface_of(grid, row, column, target), target,
                      [&](glm::dvec2, glm::dvec4 weight, glm::dvec4 difference) {
                        for (int k = 0; k < count; ++k)
                          squares += weight[k] * difference[k] * difference[k];
                      });
  return squares;
}

NormalEquations patch_equations(const LineGrid& grid, int row, int column,
                                const TargetPicture& target, const GridColumns& columns) {
  const Surface s = surface_of(grid, row, column, target);
  const Sums sums = target.is_opaque ? sums_of<3>(s, target) : sums_of<4>(s, target);
  const std::vector<PatchUnknown> unknowns =
      unknowns_of(grid, s.corners, pixels_per_unit(grid, target), columns, channels(target));
  const auto size = Eigen::Index(unknowns.size());
  NormalEquations equations{{}, Eigen::MatrixXd(size, size), Eigen::VectorXd(size), sums.squares};
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
  const Surface s = surface_of(grid, row, column, target);
  const int count = channels(target);
  // Of colours, and of opacity.
  std::array<Eigen::Matrix4d, 2> matrix{Eigen::Matrix4d::Zero(), Eigen::Matrix4d::Zero()};
  std::array<Eigen::Vector4d, most_channels> rhs;
  rhs.fill(Eigen::Vector4d::Zero());
  std::array<double, most_channels> squares{};
  for_each_difference(s, target, [&](glm::dvec2 at, glm::dvec4 weight, glm::dvec4 difference) {
    const Corners w = weights_at(at);
    const Eigen::Map<const Eigen::Vector4d> shares(w.data());
    const Eigen::Matrix4d product = shares * shares.transpose();
    matrix[0] += weight[0] * product;
    if (count == 4) matrix[1] += weight[3] * product;
    for (int k = 0; k < count; ++k) {
      const double pull = weight[k] * difference[k];
      rhs[std::size_t(k)] -= pull * shares;
      squares[std::size_t(k)] += pull * difference[k];
    }
  });
  std::vector<NormalEquations> equations;
  for (std::size_t k = 0; k < std::size_t(count); ++k)
    equations.push_back({{s.corners.begin(), s.corners.end()}, matrix[k / 3], rhs[k], squares[k]});
  return equations;
}

}  // namespace gradmesh
