#include "fit/equations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "base/clamped_int.h"
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

/// A patch at its samples, and its difference from the target there.
struct Surface {
  /// One column for each of x, y (pixels), r, g, b, a; one row for each sample.
  Eigen::MatrixXd at, by_u, by_v;
  /// By sample: its area in pixels, and how much its difference of colour counts.
  Eigen::VectorXd area, weight;
  /// By sample and channel of the picture: the difference, and the slopes over the picture.
  Eigen::MatrixXd difference, slope_x, slope_y;
  /// By sample beyond the outline: the weighted way back to it, along a normal.
  Eigen::MatrixXd normal;
  Eigen::VectorXd beyond;
};

Eigen::Matrix<double, 16, 6> control_in_pixels(const Patch& patch, const Frame& frame) {
  Eigen::Matrix<double, 16, 6> control;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const Value& v = patch.c[i][j];
      const bool is_corner = i % 3 == 0 && j % 3 == 0;
      const glm::dvec2 p =
          is_corner ? frame.to_pixels.point(v.position) : frame.to_pixels.vector(v.position);
      control.row(4 * i + j) << p.x, p.y, v.color.r, v.color.g, v.color.b, v.color.a;
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
void compare(Surface& s, Eigen::Index i, const glm::dvec3& wanted, const Robustness& robustness) {
  const double a = s.at(i, 5), det = s.by_u(i, 0) * s.by_v(i, 1) - s.by_u(i, 1) * s.by_v(i, 0);
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    const double c = s.at(i, 2 + k);
    s.difference(i, k) = a * c + 1 - a - wanted[k];
    square += s.difference(i, k) * s.difference(i, k);
    const double along_u = a * s.by_u(i, 2 + k) + (c - 1) * s.by_u(i, 5);
    const double along_v = a * s.by_v(i, 2 + k) + (c - 1) * s.by_v(i, 5);
    s.slope_x(i, k) = (along_u * s.by_v(i, 1) - along_v * s.by_u(i, 1)) / det;
    s.slope_y(i, k) = (along_v * s.by_u(i, 0) - along_u * s.by_v(i, 0)) / det;
  }
  const double beyond = 1 + square / (robustness.scale * robustness.scale);
  const double power = robustness.power;
  s.weight(i) = s.area(i) / (power == 1     ? beyond
                             : power == 0.5 ? std::sqrt(beyond)
                                            : std::pow(beyond, power));
}

void pull_back(Surface& s, Eigen::Index i, const Reference& target) {
  const glm::dvec2 place(s.at(i, 0), s.at(i, 1));
  const auto outline = target.outline_near(place);
  if (!outline) return;
  s.weight(i) = s.area(i);
  s.normal.row(i) << outline_weight * outline->normal.x, outline_weight * outline->normal.y;
  s.beyond(i) = outline_weight * glm::dot(place - outline->place, outline->normal);
}

Surface sampled(const Patch& patch, const Samples& samples, const Reference& target,
                const Robustness& robustness) {
  const auto control = control_in_pixels(patch, target.frame());
  const Eigen::Index n = samples.at.rows();
  Surface s;
  s.at = samples.at * control;
  s.by_u = samples.by_u * control;
  s.by_v = samples.by_v * control;
  s.area = ((s.by_u.col(0).array() * s.by_v.col(1).array() -
             s.by_u.col(1).array() * s.by_v.col(0).array()) /
            double(n))
               .abs();
  s.weight = s.beyond = Eigen::VectorXd::Zero(n);
  s.difference = s.slope_x = s.slope_y = Eigen::MatrixXd::Zero(n, 3);
  s.normal = Eigen::MatrixXd::Zero(n, 2);
  // Where the patch has hardly an area, as at degenerate corners, slopes say nothing.
  constexpr double flat = 1e-6;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double size =
        s.by_u.row(i).head<2>().squaredNorm() + s.by_v.row(i).head<2>().squaredNorm();
    if (s.area(i) * double(n) < flat * size) continue;
    const glm::dvec2 place(s.at(i, 0), s.at(i, 1));
    if (const auto wanted = target.color_at(place))
      compare(s, i, *wanted, robustness);
    else if (!target.is_hidden(place))
      pull_back(s, i, target);
  }
  return s;
}

/// Returns what some rows of the Jacobian add to the normal equations, which hold the same
/// functions of the unknowns, weighted.
Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::ArrayXd& weight,
                        const Eigen::MatrixXd& b) {
  return a.transpose() * weight.matrix().asDiagonal() * b;
}

/// The equations of a surface. Columns by blocks: all x, all y, all r, all g, all b.
class SurfaceEquations {
 public:
  SurfaceEquations(const std::vector<Influence>& influences, const Columns& columns) {
    for (const Influence& by : influences) {
      places_.push_back(&by);
      if (columns.color[std::size_t(by.unknown)] >= 0) colors_.push_back(&by);
    }
    for (int d = 0; d < 2; ++d)
      for (const Influence* by : places_)
        result_.columns.push_back(columns.place[std::size_t(by->unknown)] + d);
    for (int k = 0; k < 3; ++k)
      for (const Influence* by : colors_)
        result_.columns.push_back(columns.color[std::size_t(by->unknown)] + k);
    const auto size = Eigen::Index(result_.columns.size());
    result_.matrix = Eigen::MatrixXd::Zero(size, size);
    result_.rhs = Eigen::VectorXd::Zero(size);
  }

  NormalEquations run(const Surface& s, const Samples& samples) {
    const Eigen::MatrixXd place = samples.at * influence(places_, &Influence::place);
    const Eigen::MatrixXd color =
        s.at.col(5).asDiagonal() * (samples.at * influence(colors_, &Influence::color));
    add_places(s, place);
    result_.squares = (s.weight.array() *
                       (s.difference.rowwise().squaredNorm().array() + s.beyond.array().square()))
                          .sum();
    if (!colors_.empty()) {
      add_colors(s, color);
      add_both(s, place, color);
    }
    return std::move(result_);
  }

 private:
  using Part = std::array<double, 16> Influence::*;

  static Eigen::MatrixXd influence(const std::vector<const Influence*>& by, Part part) {
    Eigen::MatrixXd matrix(16, Eigen::Index(by.size()));
    for (Eigen::Index i = 0; i < matrix.cols(); ++i)
      matrix.col(i) =
          Eigen::Map<const Eigen::Matrix<double, 16, 1>>((by[std::size_t(i)]->*part).data());
    return matrix;
  }

  void add_places(const Surface& s, const Eigen::MatrixXd& place) {
    const Eigen::Index n = place.cols();
    const Eigen::ArrayXd w = s.weight.array();
    const Eigen::MatrixXd* slopes[2] = {&s.slope_x, &s.slope_y};
    for (int d = 0; d < 2; ++d) {
      for (int e = 0; e <= d; ++e) {
        Eigen::ArrayXd weight = w * ((slopes[d]->array() * slopes[e]->array()).rowwise().sum() +
                                     s.normal.col(d).array() * s.normal.col(e).array());
        if (d == e) weight += anchor * anchor * s.area.array();
        const Eigen::MatrixXd block = product(place, weight, place);
        result_.matrix.block(d * n, e * n, n, n) = block;
        result_.matrix.block(e * n, d * n, n, n) = block.transpose();
      }
      const Eigen::ArrayXd off = w * ((slopes[d]->array() * s.difference.array()).rowwise().sum() -
                                      s.normal.col(d).array() * s.beyond.array());
      result_.rhs.segment(d * n, n) = place.transpose() * off.matrix();
    }
  }

  void add_colors(const Surface& s, const Eigen::MatrixXd& color) {
    const Eigen::Index n = color.cols(), first = 2 * Eigen::Index(places_.size());
    const Eigen::MatrixXd block = product(color, s.weight.array(), color);
    for (int k = 0; k < 3; ++k) {
      result_.matrix.block(first + k * n, first + k * n, n, n) = block;
      result_.rhs.segment(first + k * n, n) =
          -color.transpose() * (s.weight.array() * s.difference.col(k).array()).matrix();
    }
  }

  void add_both(const Surface& s, const Eigen::MatrixXd& place, const Eigen::MatrixXd& color) {
    const Eigen::Index np = place.cols(), nc = color.cols();
    for (int d = 0; d < 2; ++d)
      for (int k = 0; k < 3; ++k) {
        const Eigen::ArrayXd slope = (d == 0 ? s.slope_x : s.slope_y).col(k).array();
        const Eigen::MatrixXd block = -product(color, s.weight.array() * slope, place);
        result_.matrix.block(2 * np + k * nc, d * np, nc, np) = block;
        result_.matrix.block(d * np, 2 * np + k * nc, np, nc) = block.transpose();
      }
  }

  std::vector<const Influence*> places_, colors_;
  NormalEquations result_;
};

/// How much a point of a side moves with each column that holds places: column (that of x) and
/// share.
using SideRow = std::vector<std::pair<int, double>>;

SideRow side_row(const std::vector<Influence>& influences, const Columns& columns,
                 const std::map<int, int>& local, int side, double t) {
  const double u = side == 0 ? 0 : side == 1 ? t : side == 2 ? 1 : 1 - t;
  const double v = side == 0 ? t : side == 1 ? 1 : side == 2 ? 1 - t : 0;
  const std::array<double, 16> basis = basis_products(u, v);
  SideRow row;
  for (const Influence& by : influences) {
    const int column = columns.place[std::size_t(by.unknown)];
    double share = 0;
    for (std::size_t k = 0; k < 16; ++k) share += basis[k] * by.place[k];
    if (share != 0) row.emplace_back(local.at(column), share);
  }
  return row;
}

/// Adds the distances of a side's points from the target's outline, across the outline.
void add_outline(const Patch& patch, const std::vector<Influence>& influences,
                 const Columns& columns, const std::map<int, int>& local, int side,
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
    const SideRow row = side_row(influences, columns, local, side, t);
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

NormalEquations normal_equations(const Patch& patch, const std::vector<Influence>& influences,
                                 const std::array<bool, 4>& is_outline, const Columns& columns,
                                 const Reference& target, const Robustness& robustness) {
  const Samples& samples = samples_of(sample_count(patch, 1, 3, target.frame()),
                                      sample_count(patch, 0, 2, target.frame()));
  NormalEquations equations = SurfaceEquations(influences, columns)
                                  .run(sampled(patch, samples, target, robustness), samples);
  std::map<int, int> local;
  for (int i = 0; i < int(equations.columns.size()); ++i)
    local[equations.columns[std::size_t(i)]] = i;
  for (int k = 0; k < 4; ++k)
    if (is_outline[std::size_t(k)])
      add_outline(patch, influences, columns, local, k, target, equations);
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
