#include "fit/equations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/clamped_int.h"
#include "base/per_thread.h"
#include "fit/samples.h"

namespace gradmesh {
namespace {

/// The difference of colour that counts as much as a place that is off by a pixel. It holds places
/// where colour says nothing.
constexpr double anchor = 0.5 / 255;
/// The difference of colour that counts as much as an outline that is off by a pixel.
constexpr double outline_weight = 0.2;
/// The difference of colour for a hidden outline. It is held loosely, so that a person who opens
/// the mesh tool finds the border of the mesh where it was, unless elsewhere it helps what is seen.
constexpr double hidden_outline_weight = 0.05;

constexpr std::size_t most = std::size_t(most_samples) * most_samples;
using Row = std::array<double, most>;
using Map = Eigen::Map<const Eigen::ArrayXd>;

/// A patch at its samples, and its difference from the target there; of each the first `count`
/// values are set.
struct Surface {
  int count = 0;
  /// x, y (pixels), r, g, b, a.
  std::array<Row, 6> at, by_u, by_v;
  /// The area in pixels, and how much the difference of colour counts.
  Row area, weight;
  /// By channel of the picture: the difference, and the slopes over the picture.
  std::array<Row, 3> difference;
  std::array<std::array<Row, 3>, 2> slope;
  /// Beyond the outline: the weighted way back to it, along a normal.
  std::array<Row, 2> normal;
  Row beyond;

  Map values(const Row& row) const { return {row.data(), count}; }
};

/// The control vectors of a patch in pixels, by quantity.
std::array<std::array<double, 16>, 6> control_in_pixels(const Patch& patch, const Frame& frame) {
  std::array<std::array<double, 16>, 6> control;
  for (std::size_t k = 0; k < 16; ++k) {
    const Value& value = patch.c[k / 4][k % 4];
    const bool is_corner = k / 4 % 3 == 0 && k % 4 % 3 == 0;
    const glm::dvec2 p =
        is_corner ? frame.to_pixels.point(value.position) : frame.to_pixels.vector(value.position);
    control[0][k] = p.x;
    control[1][k] = p.y;
    for (int c = 0; c < 4; ++c) control[std::size_t(2 + c)][k] = value.color[c];
  }
  return control;
}

/// Returns the number of samples along two opposite sides: one for every few pixels.
int sample_count(const Patch& patch, int side, int opposite, const Frame& frame) {
  constexpr double pixels = 5;
  double longest = 0;
  for (const int k : {side, opposite}) {
    const Cubic<Value> curve = patch.side(k);
    longest = std::max(longest,
                       glm::length(frame.to_pixels.vector(curve.p1.position - curve.p0.position)));
  }
  return clamped_int(longest / pixels, 5, most_samples);
}

/// Sets the difference, slopes and weight of the i-th sample, from the colours over white.
void compare(Surface& s, std::size_t i, const glm::dvec3& wanted, const Robustness& robustness,
             bool needs_slopes) {
  const double a = s.at[5][i];
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double difference = a * s.at[2 + k][i] + 1 - a - wanted[glm::length_t(k)];
    s.difference[k][i] = difference;
    square += difference * difference;
  }
  const double beyond = 1 + square / (robustness.scale * robustness.scale);
  const double power = robustness.power;
  s.weight[i] = s.area[i] / (power == 1     ? beyond
                             : power == 0.5 ? std::sqrt(beyond)
                                            : std::pow(beyond, power));
  if (!needs_slopes) return;
  const double share = 1 / (s.by_u[0][i] * s.by_v[1][i] - s.by_u[1][i] * s.by_v[0][i]);
  for (std::size_t k = 0; k < 3; ++k) {
    const double c = s.at[2 + k][i] - 1;
    const double along_u = a * s.by_u[2 + k][i] + c * s.by_u[5][i];
    const double along_v = a * s.by_v[2 + k][i] + c * s.by_v[5][i];
    s.slope[0][k][i] = (along_u * s.by_v[1][i] - along_v * s.by_u[1][i]) * share;
    s.slope[1][k][i] = (along_v * s.by_u[0][i] - along_u * s.by_v[0][i]) * share;
  }
}

void pull_back(Surface& s, std::size_t i, const Reference& target) {
  const glm::dvec2 place(s.at[0][i], s.at[1][i]);
  const auto outline = target.outline_near(place);
  if (!outline) return;
  s.weight[i] = s.area[i];
  for (std::size_t d = 0; d < 2; ++d)
    s.normal[d][i] = outline_weight * outline->normal[glm::length_t(d)];
  s.beyond[i] = outline_weight * glm::dot(place - outline->place, outline->normal);
}

/// Sets the samples to nothing that counts.
void clear(Surface& s) {
  const auto set = [&](Row& row) { std::fill_n(row.begin(), s.count, 0.0); };
  set(s.weight);
  set(s.beyond);
  for (Row& row : s.difference) set(row);
  for (auto& rows : s.slope)
    for (Row& row : rows) set(row);
  for (Row& row : s.normal) set(row);
}

/// Samples a patch; slopes are needed only where something moves.
void sample(const Patch& patch, const Parts& u, const Parts& v, const Reference& target,
            const Robustness& robustness, bool needs_slopes, Surface& s) {
  const auto control = control_in_pixels(patch, target.frame());
  s.count = u.count * v.count;
  for (std::size_t k = 0; k < 6; ++k) {
    sum_up(control[k], u.at, u.count, v.at, v.count, s.at[k].data());
    if (k >= 2 && !needs_slopes) continue;
    sum_up(control[k], u.along, u.count, v.at, v.count, s.by_u[k].data());
    sum_up(control[k], u.at, u.count, v.along, v.count, s.by_v[k].data());
  }
  clear(s);
  // Where the patch has hardly an area, as at degenerate corners, slopes say nothing.
  constexpr double flat = 1e-6;
  for (std::size_t i = 0; i < std::size_t(s.count); ++i) {
    const double xu = s.by_u[0][i], yu = s.by_u[1][i], xv = s.by_v[0][i], yv = s.by_v[1][i],
                 size = std::abs(xu * yv - yu * xv);
    s.area[i] = size / s.count;
    if (size < flat * (xu * xu + yu * yu + xv * xv + yv * yv)) continue;
    const glm::dvec2 place(s.at[0][i], s.at[1][i]);
    if (const auto wanted = target.color_at(place))
      compare(s, i, *wanted, robustness, needs_slopes);
    else if (!target.is_hidden(place))
      pull_back(s, i, target);
  }
}

double squares_of(const Surface& s) {
  double squares = 0;
  for (std::size_t i = 0; i < std::size_t(s.count); ++i)
    squares += s.weight[i] *
               (s.difference[0][i] * s.difference[0][i] + s.difference[1][i] * s.difference[1][i] +
                s.difference[2][i] * s.difference[2][i] + s.beyond[i] * s.beyond[i]);
  return squares;
}

/// Returns what some rows of the Jacobian add to the normal equations, which hold the same
/// functions of the unknowns, weighted.
template <class Weight>
Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Weight& weight, const Eigen::MatrixXd& b) {
  const Eigen::MatrixXd weighted = b.array().colwise() * weight;
  return a.transpose().lazyProduct(weighted);
}

/// The equations of a surface, in the columns of columns_of().
class SurfaceEquations {
 public:
  SurfaceEquations(const std::vector<Influence>& influences, const Columns& columns) {
    for (const Influence& by : influences) {
      places_.push_back(&by);
      if (columns.color[std::size_t(by.unknown)] >= 0) colors_.push_back(&by);
    }
    result_.columns = columns_of(influences, columns);
    const auto size = Eigen::Index(result_.columns.size());
    result_.matrix = Eigen::MatrixXd::Zero(size, size);
    result_.rhs = Eigen::VectorXd::Zero(size);
  }

  NormalEquations run(const Surface& s, const Parts& u, const Parts& v) {
    result_.squares = squares_of(s);
    if (places_.empty()) return std::move(result_);
    const Eigen::MatrixXd place = influence(places_, &Influence::place, u, v);
    add_places(s, place);
    if (!colors_.empty()) {
      Eigen::MatrixXd color = influence(colors_, &Influence::color, u, v);
      color.array().colwise() *= s.values(s.at[5]);
      add_colors(s, color);
      add_both(s, place, color);
    }
    return std::move(result_);
  }

 private:
  using Part = std::array<double, 16> Influence::*;

  static Eigen::MatrixXd influence(const std::vector<const Influence*>& by, Part part,
                                   const Parts& u, const Parts& v) {
    Eigen::MatrixXd matrix(u.count * v.count, Eigen::Index(by.size()));
    for (Eigen::Index i = 0; i < matrix.cols(); ++i)
      sum_up(by[std::size_t(i)]->*part, u.at, u.count, v.at, v.count, matrix.col(i).data());
    return matrix;
  }

  void add_places(const Surface& s, const Eigen::MatrixXd& place) {
    const Eigen::Index n = place.cols();
    const Map w = s.values(s.weight);
    for (std::size_t d = 0; d < 2; ++d) {
      const Eigen::Index row = Eigen::Index(d) * n;
      for (std::size_t e = 0; e <= d; ++e) {
        const Eigen::Index column = Eigen::Index(e) * n;
        Eigen::ArrayXd weight = s.values(s.normal[d]) * s.values(s.normal[e]);
        for (std::size_t k = 0; k < 3; ++k)
          weight += s.values(s.slope[d][k]) * s.values(s.slope[e][k]);
        weight *= w;
        if (d == e) weight += anchor * anchor * s.values(s.area);
        const Eigen::MatrixXd block = product(place, weight, place);
        result_.matrix.block(row, column, n, n) = block;
        result_.matrix.block(column, row, n, n) = block.transpose();
      }
      Eigen::ArrayXd off = -s.values(s.normal[d]) * s.values(s.beyond);
      for (std::size_t k = 0; k < 3; ++k)
        off += s.values(s.slope[d][k]) * s.values(s.difference[k]);
      off *= w;
      result_.rhs.segment(row, n) = place.transpose() * off.matrix();
    }
  }

  void add_colors(const Surface& s, const Eigen::MatrixXd& color) {
    const Eigen::Index n = color.cols(), first = 2 * Eigen::Index(places_.size());
    const Eigen::MatrixXd block = product(color, s.values(s.weight), color);
    for (int k = 0; k < 3; ++k) {
      result_.matrix.block(first + k * n, first + k * n, n, n) = block;
      result_.rhs.segment(first + k * n, n) =
          -color.transpose() *
          (s.values(s.weight) * s.values(s.difference[std::size_t(k)])).matrix();
    }
  }

  void add_both(const Surface& s, const Eigen::MatrixXd& place, const Eigen::MatrixXd& color) {
    const Eigen::Index np = place.cols(), nc = color.cols();
    for (int d = 0; d < 2; ++d)
      for (int k = 0; k < 3; ++k) {
        const Eigen::ArrayXd weight =
            -s.values(s.weight) * s.values(s.slope[std::size_t(d)][std::size_t(k)]);
        const Eigen::MatrixXd block = product(color, weight, place);
        result_.matrix.block(2 * np + k * nc, d * np, nc, np) = block;
        result_.matrix.block(d * np, 2 * np + k * nc, np, nc) = block.transpose();
      }
  }

  std::vector<const Influence*> places_, colors_;
  NormalEquations result_;
};

/// How much a point of a side moves with each influence: its number, which is that of its column
/// of x, and share.
using SideRow = std::vector<std::pair<int, double>>;

SideRow side_row(const std::vector<Influence>& influences, int side, double t) {
  const double u = side == 0 ? 0 : side == 1 ? t : side == 2 ? 1 : 1 - t;
  const double v = side == 0 ? t : side == 1 ? 1 : side == 2 ? 1 - t : 0;
  const std::array<double, 16> basis = basis_products(u, v);
  SideRow row;
  int number = 0;
  for (const Influence& by : influences) {
    double share = 0;
    for (std::size_t k = 0; k < 16; ++k) share += basis[k] * by.place[k];
    if (share != 0) row.emplace_back(number, share);
    ++number;
  }
  return row;
}

/// Adds the distances of a side's points from the target's outline, across the outline.
void add_outline(const Patch& patch, const std::vector<Influence>& influences, int side,
                 const Reference& target, NormalEquations& equations) {
  const Cubic<glm::dvec2> line = in_pixels(patch.side(side), target.frame());
  const int steps = clamped_int(glm::length(line.p1 - line.p0) / 3, 6, 40);
  // y follows x, by as many columns as there are places.
  const int to_y = int(influences.size());
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) / steps;
    const auto outline = target.outline_near(line.at(t));
    if (!outline) continue;
    const glm::dvec2 normal = outline->normal;
    const double off = glm::dot(line.at(t) - outline->place, normal);
    const double by_pixel = target.is_hidden(line.at(t)) ? hidden_outline_weight : outline_weight;
    const double weight = by_pixel * by_pixel * glm::length(line.derivative(t)) / steps;
    equations.squares += weight * off * off;
    const SideRow row = side_row(influences, side, t);
    for (const auto& [a, share_a] : row)
      for (int d = 0; d < 2; ++d) {
        equations.rhs(a + d * to_y) -= weight * share_a * normal[d] * off;
        for (const auto& [b, share_b] : row)
          for (int e = 0; e < 2; ++e)
            equations.matrix(a + d * to_y, b + e * to_y) +=
                weight * share_a * share_b * normal[d] * normal[e];
      }
  }
}

}  // namespace

Columns::Columns(const std::vector<Unknown>& unknowns) {
  for (const Unknown& unknown : unknowns) {
    place.push_back(count);
    count += 2;
    color.push_back(unknown.moves_color ? count : -1);
    if (unknown.moves_color) count += 3;
  }
}

Columns::Columns(int places) : color(std::size_t(places), -1), count(2 * places) {
  for (int i = 0; i < places; ++i) place.push_back(2 * i);
}

std::vector<int> columns_of(const std::vector<Influence>& influences, const Columns& columns) {
  std::vector<int> result;
  for (int d = 0; d < 2; ++d)
    for (const Influence& by : influences)
      result.push_back(columns.place[std::size_t(by.unknown)] + d);
  for (int k = 0; k < 3; ++k)
    for (const Influence& by : influences)
      if (const int first = columns.color[std::size_t(by.unknown)]; first >= 0)
        result.push_back(first + k);
  return result;
}

NormalEquations normal_equations(const Patch& patch, const std::vector<Influence>& influences,
                                 const std::array<bool, 4>& is_outline, const Columns& columns,
                                 const Reference& target, const Robustness& robustness) {
  const Parts& u = parts_of(sample_count(patch, 1, 3, target.frame()));
  const Parts& v = parts_of(sample_count(patch, 0, 2, target.frame()));
  Surface& surface = per_thread<Surface>();
  sample(patch, u, v, target, robustness, !influences.empty(), surface);
  NormalEquations equations = SurfaceEquations(influences, columns).run(surface, u, v);
  for (int k = 0; k < 4; ++k)
    if (is_outline[std::size_t(k)]) add_outline(patch, influences, k, target, equations);
  return equations;
}

NormalEquations normal_equations(const Mesh& mesh, const InfluencedFace& face,
                                 const Columns& columns, const Reference& target) {
  const std::array<Halfedge, 4> sides = mesh.sides(face.face);
  std::array<bool, 4> are_outlines;
  for (std::size_t k = 0; k < 4; ++k) are_outlines[k] = is_outline(mesh, mesh.curve_side(sides[k]));
  return normal_equations(mesh.patch(face.face), face.by, are_outlines, columns, target);
}

}  // namespace gradmesh
