#include "formats/pdf/grid/refined_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "base/clamped_int.h"

namespace gradmesh {
namespace {

/// Along each side of the artist's patches, and in all.
constexpr int most_along_side = 8;
constexpr double most_samples = 20000;
/// Colours that are nearer, as a rule, look the same: documents round them to multiples of 1 / 255.
constexpr double rounding = 0.5 / 255;
/// How many samples are looked at until a grid is as fine as it gets: some seconds.
constexpr double most_looks = 1e7;
/// No part of an artist's patch is smaller than this share of it.
constexpr double least_part = 1.0 / 8;

/// Returns the row of the artist that a place lies in, the one before where it is on a line.
std::size_t before(double line, std::size_t count) {
  return std::min(std::size_t(std::max(0.0, std::ceil(line) - 1)), count - 1);
}

/// Returns the artist's row in which the part between two lines lies, and the shares of it.
struct Part {
  std::size_t of;
  double from, to;
};
Part part_between(double from, double to) {
  const double of = std::floor(0.5 * (from + to));
  return {std::size_t(of), from - of, to - of};
}

glm::dvec4 rounded(glm::dvec4 color) {
  for (int channel = 0; channel < 3; ++channel)
    color[channel] = std::round(255 * color[channel]) / 255;
  return color;
}

std::vector<double> with_line(std::vector<double> lines, double line) {
  lines.insert(std::ranges::lower_bound(lines, line), line);
  return lines;
}

}  // namespace

RefinedGrid::RefinedGrid(PatchGrid grid, const PageColors& page)
    : artists_(std::move(grid)), page_(page) {
  for (int i = 0; i <= artists_.rows; ++i) row_lines_.push_back(i);
  for (int j = 0; j <= artists_.columns; ++j) column_lines_.push_back(j);
  const int along_side =
      clamped_int(std::sqrt(most_samples / double(artists_.patches.size())), 1, most_along_side);
  for (int i = 0; i < along_side * artists_.rows; ++i)
    for (int j = 0; j < along_side * artists_.columns; ++j) {
      const double row = (i + 0.5) / along_side, column = (j + 0.5) / along_side;
      const glm::dvec2 place =
          artists(row, column).at(row - std::floor(row), column - std::floor(column)).position;
      samples_.push_back({row, column, page_.at(place)});
    }
  error_ = error(row_lines_, column_lines_);
}

const Patch& RefinedGrid::artists(double row, double column) const {
  const std::size_t i = before(row, std::size_t(artists_.rows)),
                    j = before(column, std::size_t(artists_.columns));
  return artists_.patches[i * std::size_t(artists_.columns) + j];
}

const Value& RefinedGrid::corner(double row, double column) const {
  const auto [known, is_new] = corners_.try_emplace({row, column});
  Value& value = known->second;
  if (is_new) {
    const double i = double(before(row, std::size_t(artists_.rows))),
                 j = double(before(column, std::size_t(artists_.columns)));
    value = artists(row, column).at(row - i, column - j);
    // The artist's own corners have the colours of the page already.
    if (row != std::floor(row) || column != std::floor(column))
      value.color = rounded(page_.at(value.position));
  }
  return value;
}

SmoothColors RefinedGrid::colors(const Lines& rows, const Lines& columns) const {
  std::vector<Corner> corners;
  for (const double row : rows)
    for (const double column : columns) {
      const Value& value = corner(row, column);
      corners.push_back({value.position, glm::dvec3(value.color)});
    }
  return {int(rows.size()) - 1, int(columns.size()) - 1, corners};
}

void RefinedGrid::set_corners(Patch& patch, const Lines& rows, const Lines& columns, std::size_t i,
                              std::size_t j) const {
  for (const std::size_t k : {0U, 1U})
    for (const std::size_t l : {0U, 1U})
      patch.c[3 * k][3 * l] = corner(rows[i + k], columns[j + l]);
}

double RefinedGrid::error(const Lines& rows, const Lines& columns) {
  looks_ += double(samples_.size());
  const SmoothColors smooth = colors(rows, columns);
  std::vector<std::optional<Patch>> patches((rows.size() - 1) * (columns.size() - 1));
  const auto cell = [](const Lines& lines, double place) {
    return std::size_t(std::ranges::upper_bound(lines, place) - lines.begin()) - 1;
  };
  double sum = 0;
  for (const auto& [row, column, color] : samples_) {
    const std::size_t i = cell(rows, row), j = cell(columns, column);
    std::optional<Patch>& patch = patches[i * (columns.size() - 1) + j];
    if (!patch) {
      patch.emplace();
      set_corners(*patch, rows, columns, i, j);
      smooth.apply(*patch, int(i), int(j));
    }
    const glm::dvec4 seen = patch
                                ->at((row - rows[i]) / (rows[i + 1] - rows[i]),
                                     (column - columns[j]) / (columns[j + 1] - columns[j]))
                                .color;
    const glm::dvec4 differs = glm::clamp(seen, 0.0, 1.0) - color;
    sum += glm::dot(differs, differs);
  }
  return sum;
}

PatchGrid RefinedGrid::grid() const {
  PatchGrid grid{rows(), columns(), {}};
  for (std::size_t i = 0; i + 1 < row_lines_.size(); ++i)
    for (std::size_t j = 0; j + 1 < column_lines_.size(); ++j) {
      const Part row = part_between(row_lines_[i], row_lines_[i + 1]),
                 column = part_between(column_lines_[j], column_lines_[j + 1]);
      Patch& patch = grid.patches.emplace_back(
          artists_.patches[row.of * std::size_t(artists_.columns) + column.of]);
      patch = patch.part_u(row.from, row.to).part_v(column.from, column.to);
      set_corners(patch, row_lines_, column_lines_, i, j);
      make_color_bilinear(patch);
    }
  return grid;
}

bool RefinedGrid::divide() {
  if (looks_ > most_looks || error_ <= rounding * rounding * double(samples_.size())) return false;
  double best_gain = 0;
  std::optional<std::pair<Lines, Lines>> best;
  double best_error = error_;
  const auto consider = [&](Lines rows, Lines columns) {
    const double after = error(rows, columns);
    const std::size_t added = (rows.size() - 1) * (columns.size() - 1) -
                              (row_lines_.size() - 1) * (column_lines_.size() - 1);
    const double gain = (error_ - after) / double(added);
    if (gain <= best_gain) return;
    best_gain = gain;
    best_error = after;
    best = {std::move(rows), std::move(columns)};
  };
  const auto middles = [](const Lines& lines) {
    Lines all;
    for (std::size_t k = 0; k + 1 < lines.size(); ++k)
      if (lines[k + 1] - lines[k] >= 2 * least_part) all.push_back(0.5 * (lines[k] + lines[k + 1]));
    return all;
  };
  for (const double line : middles(row_lines_))
    consider(with_line(row_lines_, line), column_lines_);
  for (const double line : middles(column_lines_))
    consider(row_lines_, with_line(column_lines_, line));
  if (!best) return false;
  std::tie(row_lines_, column_lines_) = *best;
  error_ = best_error;
  return true;
}

}  // namespace gradmesh
