#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "base/affine.h"
#include "form/cut_blocks.h"
#include "geom/box.h"
#include "geom/nearest.h"

namespace gradmesh {
namespace {

using Curve = Cubic<glm::dvec2>;

/// The distance, as a share of a block's size, within which two places are the same.
constexpr double same_shape = 1e-3;

/// The lines of a block in one direction: lines across it, at which rows begin and end, or lines
/// down, at which columns do.
class Lines {
 public:
  Lines(const PatchGrid& block, bool down) : block_(block), down_(down) {}

  int count() const { return (down_ ? block_.columns : block_.rows) + 1; }
  /// Returns the number of corners on each line.
  int corners() const { return (down_ ? block_.rows : block_.columns) + 1; }

  Value corner(int line, int k) const {
    const int row = down_ ? k : line, column = down_ ? line : k;
    const int i = std::min(row, block_.rows - 1), j = std::min(column, block_.columns - 1);
    constexpr int names[2][2] = {{0, 1}, {3, 2}};
    return patch(i, j).corner(names[row - i][column - j]);
  }

  /// Returns the curve from a line's corner to that of the next line.
  Curve curve(int line, int k) const {
    const bool last = k + 1 == corners();
    const Patch& p = down_ ? patch(k - last, line) : patch(line, k - last);
    const Cubic<Value> side = down_ ? (last ? p.side(2).reversed() : p.side(0))
                                    : (last ? p.side(1) : p.side(3).reversed());
    return {side.p0.position, side.m0.position, side.m1.position, side.p1.position};
  }

 private:
  const Patch& patch(int row, int column) const {
    return block_.patches[std::size_t(row) * std::size_t(block_.columns) + std::size_t(column)];
  }

  const PatchGrid& block_;
  const bool down_;
};

/// For each line, and each corner of a line, of before, which it is now.
using Places = std::vector<int>;
/// For each line of before, how far it lies from each of now.
using Distances = std::vector<std::vector<double>>;

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() - 1) / 2;
  std::ranges::nth_element(values, middle);
  return *middle;
}

Distances reversed(Distances distances) {
  std::ranges::reverse(distances);
  for (std::vector<double>& row : distances) std::ranges::reverse(row);
  return distances;
}

/// Returns the least sum of distances with which the lines up to each are lines of now, in their
/// order and the first as the first.
Distances sums(const Distances& distances) {
  constexpr double never = std::numeric_limits<double>::infinity();
  Distances sums(distances.size(), std::vector<double>(distances[0].size(), never));
  sums[0][0] = distances[0][0];
  for (std::size_t i = 1; i < distances.size(); ++i) {
    double best = never;
    for (std::size_t k = 1; k < distances[i].size(); ++k) {
      best = std::min(best, sums[i - 1][k - 1]);
      sums[i][k] = best + distances[i][k];
    }
  }
  return sums;
}

struct Alignment {
  Places places;
  /// The sum of the distances of the lines.
  double distance = 0;
  /// True if another alignment is as likely.
  bool is_unclear = false;
};

/// Returns which lines of now are those of before, the first and the last as the first and the
/// last. `same` is a distance that is none.
Alignment align(const Distances& distances, double same) {
  const Distances before = sums(distances), after = reversed(sums(reversed(distances)));
  const auto through = [&](std::size_t i, std::size_t k) {
    return before[i][k] + after[i][k] - distances[i][k];
  };
  Alignment result;
  double farthest = same;
  std::size_t k = 0;
  for (std::size_t i = 0; i < distances.size(); ++i, ++k) {
    const std::size_t from = k;
    for (std::size_t other = from; other < distances[i].size(); ++other)
      if (through(i, other) < through(i, k)) k = other;
    result.places.push_back(int(k));
    farthest = std::max(farthest, distances[i][k]);
  }
  const double best = before.back().back();
  result.distance = best;
  for (std::size_t i = 0; i < distances.size(); ++i)
    for (std::size_t other = 0; other < distances[i].size(); ++other) {
      const bool likely = through(i, other) < best + 0.3 * farthest;
      if (int(other) != result.places[i] && likely && best > same) result.is_unclear = true;
    }
  return result;
}

/// Returns the diagonal of the box around the corners of a block.
double size_of(const PatchGrid& block) {
  Box box;
  for (const Patch& patch : block.patches)
    for (int k = 0; k < 4; ++k) box.add(patch.corner(k).position);
  return std::max(glm::length(box.size()), 1e-9);
}

/// Returns the outer corners of a block, row by row.
std::array<glm::dvec2, 4> outer_corners(const PatchGrid& block) {
  const Lines lines(block, false);
  const int bottom = lines.count() - 1, right = lines.corners() - 1;
  return {lines.corner(0, 0).position, lines.corner(0, right).position,
          lines.corner(bottom, 0).position, lines.corner(bottom, right).position};
}

/// Returns the map by which a block as a whole was scaled, turned or sheared, if it takes all four
/// outer corners to where they are now, to within `same` in the unit before. Nothing if the map, or
/// its inverse, would not be known from them.
std::optional<Affine> affine_between(const std::array<glm::dvec2, 4>& before,
                                     const std::array<glm::dvec2, 4>& now, double same) {
  const auto frame = [](const std::array<glm::dvec2, 4>& p) {
    return Affine{glm::dmat2(0.5 * (p[1] - p[0] + p[3] - p[2]), 0.5 * (p[2] - p[0] + p[3] - p[1])),
                  0.25 * (p[0] + p[1] + p[2] + p[3])};
  };
  const Affine from = frame(before), to = frame(now);
  const double flat = same * same;
  if (std::abs(from.determinant()) <= flat || !(std::abs(to.determinant()) > 0))
    return std::nullopt;
  const Affine map = to * from.inverse();
  if (!(std::abs(map.determinant()) > 1e-12)) return std::nullopt;
  const Affine back = map.inverse();
  for (std::size_t k = 0; k < 4; ++k)
    if (!(glm::distance(back.point(now[k]), before[k]) <= same)) return std::nullopt;
  return map;
}

/// Returns how a block as a whole was moved, if half of its outer corners are where that takes
/// them.
Affine shift_between(const std::array<glm::dvec2, 4>& before,
                     const std::array<glm::dvec2, 4>& now) {
  std::vector<double> x, y;
  for (std::size_t k = 0; k < 4; ++k) {
    x.push_back(now[k].x - before[k].x);
    y.push_back(now[k].y - before[k].y);
  }
  return Affine::translation({median(x), median(y)});
}

class CutFinder {
 public:
  /// `by` takes the block as a whole from where it was written to where it is.
  CutFinder(const PatchGrid& written, PatchGrid read, const Affine& by)
      : written_(written), read_(std::move(read)), size_(size_of(written)) {
    const Affine back = by.inverse();
    for (Patch& patch : read_.patches) transform(patch, back);
  }

  struct Found {
    /// Nothing if it cannot be told.
    std::optional<BlockCuts> cuts;
    /// How far the lines are from those of before.
    double distance;
  };

  Found run() const {
    const Places nothing;
    const Places guessed = aligned(false, nothing).places;
    const Alignment columns = aligned(true, guessed), rows = aligned(false, columns.places);
    const double distance = columns.distance + rows.distance;
    if (columns.is_unclear || rows.is_unclear) return {std::nullopt, distance};
    return {BlockCuts{cuts(false, rows.places, columns.places),
                      cuts(true, columns.places, rows.places)},
            distance};
  }

 private:
  double distance(const Value& before, const Value& now) const {
    // Opacities may be in a mask, which the mesh tool does not cut.
    const glm::dvec3 color(before.color - now.color);
    return glm::distance(before.position, now.position) + 0.05 * size_ * glm::length(color);
  }

  /// Returns which lines of now are those of before, if the corners on them are known, or all
  /// corners count.
  Alignment aligned(bool down, const Places& corners) const {
    const Lines before(written_, down), now(read_, down);
    Distances distances(std::size_t(before.count()), std::vector<double>(std::size_t(now.count())));
    for (int i = 0; i < before.count(); ++i)
      for (int k = 0; k < now.count(); ++k)
        distances[std::size_t(i)][std::size_t(k)] = distance(before, i, now, k, corners);
    return align(distances, same_shape * size_);
  }

  double distance(const Lines& before, int line, const Lines& now, int other,
                  const Places& corners) const {
    double sum = 0;
    for (int c = 0; c < before.corners(); ++c) {
      const Value corner = before.corner(line, c);
      double least = std::numeric_limits<double>::infinity();
      for (int d = 0; d < now.corners(); ++d)
        if (corners.empty() || corners[std::size_t(c)] == d)
          least = std::min(least, distance(corner, now.corner(other, d)));
      sum += least;
    }
    return sum / before.corners();
  }

  /// Returns for each row or column where the new lines are.
  std::vector<std::vector<double>> cuts(bool down, const Places& lines,
                                        const Places& corners) const {
    std::vector<std::vector<double>> result;
    for (int i = 0; i + 1 < int(lines.size()); ++i) {
      const int count = lines[std::size_t(i) + 1] - lines[std::size_t(i)] - 1;
      std::vector<double>& places = result.emplace_back();
      for (int k = 1; k <= count; ++k) {
        constexpr double gap = 1e-6;
        const double low = places.empty() ? gap : places.back() + gap;
        const double t = place(down, i, lines, k, corners);
        // By rounding the bounds may be in the wrong order where the last line is at the highest.
        places.push_back(std::min(1 - gap * (1 + count - k), std::max(low, t)));
      }
    }
    return result;
  }

  /// Returns where the k-th new line is between a line of before and the next. By a corner that was
  /// moved alone only the place on the curve of before is another one, and by one of its handles
  /// only the share of the lengths of both.
  double place(bool down, int line, const Places& lines, int k, const Places& corners) const {
    const Lines before(written_, down), now(read_, down);
    const int first = lines[std::size_t(line)], end = lines[std::size_t(line) + 1];
    std::vector<double> places;
    for (int c = 0; c < before.corners(); ++c) {
      const int corner = corners[std::size_t(c)];
      const Curve curve = before.curve(line, c);
      const glm::dvec2 put = now.corner(first + k, corner).position;
      if (glm::distance(curve.p0, curve.p1) > 1e-3 * size_)
        places.push_back(nearest(curve, put, 0, 1));
      if (const auto share = share_before(now, first, first + k, end, corner))
        places.push_back(*share);
    }
    return places.empty() ? double(k) / (end - first) : median(places);
  }

  /// Returns the share that curves before a line have of one that was cut into all of them: at a
  /// cut, handles are to each other as the parts. Nothing where there is no handle.
  std::optional<double> share_before(const Lines& now, int first, int line, int end,
                                     int corner) const {
    double length = 1, all = 1, part = 0;
    for (int i = first + 1; i < end; ++i) {
      if (i == line) part = all;
      const double back = glm::length(now.curve(i - 1, corner).m1);
      const double forth = glm::length(now.curve(i, corner).m0);
      if (std::min(back, forth) < 1e-4 * size_) return std::nullopt;
      length *= forth / back;
      all += length;
    }
    return part / all;
  }

  const PatchGrid& written_;
  /// Moved back to where the block was when it was written.
  PatchGrid read_;
  const double size_;
};

}  // namespace

std::optional<BlockCuts> find_cuts(const PatchGrid& written, const PatchGrid& read) {
  const auto before = outer_corners(written), now = outer_corners(read);
  CutFinder::Found found = CutFinder(written, read, shift_between(before, now)).run();
  if (const auto by = affine_between(before, now, same_shape * size_of(written))) {
    CutFinder::Found other = CutFinder(written, read, *by).run();
    if (other.distance < 0.5 * found.distance) found = std::move(other);
  }
  return found.cuts;
}

}  // namespace gradmesh
