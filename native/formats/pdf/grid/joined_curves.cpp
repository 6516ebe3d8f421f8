#include "formats/pdf/grid/joined_curves.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "geom/nearest.h"

namespace gradmesh {
namespace {

/// Returns how much each control point of a curve counts in control point n of its part.
std::array<double, 4> shares_in(std::size_t n, double from, double to) {
  // A control point of a part is the curve's blossom of as many times `to` as its number says.
  const auto at = [n, from, to](std::size_t k) { return k < n ? to : from; };
  const double x = at(0), y = at(1), z = at(2);
  return {(1 - x) * (1 - y) * (1 - z),
          x * (1 - y) * (1 - z) + (1 - x) * y * (1 - z) + (1 - x) * (1 - y) * z,
          x * y * (1 - z) + x * (1 - y) * z + (1 - x) * y * z, x * y * z};
}

ControlRow ends_of(std::span<const CurvePart> parts) {
  ControlRow row{parts.front().row[0], {}, {}, {}};
  for (const CurvePart& part : parts)
    if (part.to >= 1) row[3] = part.row[3];
  return row;
}

/// The two inner points of a curve of which the ends are known, by least squares.
class InnerPoints {
 public:
  explicit InnerPoints(const ControlRow& ends) : row_(ends) {}

  /// Adds what a sum of the four points, each with its share, is to be.
  void add(const std::array<double, 4>& shares, glm::dvec2 sum, double weight) {
    const glm::dvec2 rest = sum - shares[0] * row_[0] - shares[3] * row_[3];
    first_ += weight * shares[1] * shares[1];
    both_ += weight * shares[1] * shares[2];
    second_ += weight * shares[2] * shares[2];
    by_first_ += weight * shares[1] * rest;
    by_second_ += weight * shares[2] * rest;
  }

  ControlRow row() const {
    const double determinant = first_ * second_ - both_ * both_;
    // Where all lies at one end there is nothing between.
    if (!(determinant > 0)) return {row_[0], row_[0], row_[3], row_[3]};
    return {row_[0], (second_ * by_first_ - both_ * by_second_) / determinant,
            (first_ * by_second_ - both_ * by_first_) / determinant, row_[3]};
  }

 private:
  ControlRow row_;
  /// The normal equations.
  double first_ = 0, both_ = 0, second_ = 0;
  glm::dvec2 by_first_{0.0}, by_second_{0.0};
};

}  // namespace

Cubic<glm::dvec2> cubic_of(const ControlRow& row) {
  return Cubic<glm::dvec2>::from_bezier(row[0], row[1], row[2], row[3]);
}

double nearest_on(const ControlRow& row, glm::dvec2 place) {
  return nearest(cubic_of(row), place, 0, 1);
}

double length_of(const ControlRow& row) {
  constexpr int steps = 16;
  const auto line = cubic_of(row);
  double sum = 0;
  for (int n = 0; n < steps; ++n)
    sum += glm::distance(line.at(double(n) / steps), line.at(double(n + 1) / steps));
  return sum;
}

ControlRow reversed_row(const ControlRow& row) { return {row[3], row[2], row[1], row[0]}; }

ControlRow part_of(const ControlRow& row, double from, double to) {
  ControlRow part{};
  for (std::size_t n = 0; n < 4; ++n) {
    const auto shares = shares_in(n, from, to);
    for (std::size_t k = 0; k < 4; ++k) part[n] += shares[k] * row[k];
  }
  return part;
}

ControlRow closest_whole(std::span<const CurvePart> parts) {
  InnerPoints inner(ends_of(parts));
  for (const CurvePart& part : parts)
    for (std::size_t n = 0; n < 4; ++n) inner.add(shares_in(n, part.from, part.to), part.row[n], 1);
  return inner.row();
}

ControlRow closest_line(std::span<const CurvePart> parts) {
  // What is a part of it but for rounding needs no search.
  constexpr double rounding = 1e-3;
  constexpr int steps = 8, rounds = 20;
  ControlRow row = closest_whole(parts);
  if (deviation(row, parts) <= rounding) return row;
  struct Sample {
    glm::dvec2 place;
    double weight;
  };
  std::vector<Sample> samples;
  for (const CurvePart& part : parts) {
    const auto line = cubic_of(part.row);
    for (int n = 0; n < steps; ++n) {
      const double t = (n + 0.5) / steps;
      samples.push_back({line.at(t), glm::length(line.derivative(t))});
    }
  }
  for (int round = 0; round < rounds; ++round) {
    InnerPoints inner(ends_of(parts));
    const auto line = cubic_of(row);
    for (const Sample& sample : samples) {
      const double t = nearest(line, sample.place, 0, 1);
      inner.add(shares_in(0, t, t), sample.place, sample.weight);
    }
    const ControlRow closer = inner.row();
    const bool is_still =
        glm::distance(row[1], closer[1]) + glm::distance(row[2], closer[2]) < 1e-6;
    row = closer;
    if (is_still) break;
  }
  return row;
}

double deviation(const ControlRow& whole, std::span<const CurvePart> parts) {
  double largest = 0;
  for (const CurvePart& part : parts) {
    const ControlRow wanted = part_of(whole, part.from, part.to);
    for (std::size_t n = 0; n < 4; ++n)
      largest = std::max(largest, glm::distance(wanted[n], part.row[n]));
  }
  return largest;
}

std::vector<CurvePart> parts_by_speed(std::span<const ControlRow> rows) {
  // How long the parameter of each part is, the first being 1.
  std::vector<double> shares{1.0};
  for (std::size_t n = 1; n < rows.size(); ++n) {
    const double in = glm::distance(rows[n - 1][2], rows[n - 1][3]);
    const double out = glm::distance(rows[n][0], rows[n][1]);
    const double ratio = in > 0 && out > 0 ? out / in : length_of(rows[n]) / length_of(rows[n - 1]);
    // Curves of a stranger may have any speed, or no length.
    constexpr double most = 1e100;
    const double share = shares.back() * ratio;
    shares.push_back(share > 0 ? std::clamp(share, 1 / most, most) : 1 / most);
  }
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  std::vector<CurvePart> parts;
  double from = 0;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const double to = n + 1 < rows.size() ? from + shares[n] / sum : 1;
    parts.push_back({rows[n], from, to});
    from = to;
  }
  return parts;
}

double distance_of_line(const ControlRow& row, const ControlRow& other) {
  constexpr int steps = 16;
  const auto line = cubic_of(row), beside = cubic_of(other);
  double largest = 0;
  for (int n = 0; n <= steps; ++n) {
    const glm::dvec2 place = line.at(double(n) / steps);
    largest = std::max(largest, glm::distance(place, beside.at(nearest(beside, place, 0, 1))));
  }
  return largest;
}

}  // namespace gradmesh
