#include "trace/guided_grid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "base/clamped_int.h"
#include "trace/grid_map.h"
#include "trace/guide_track.h"

namespace gradmesh {
namespace {

/// In units of the grid: closer to each other lines would only jam.
constexpr double least_gap = 2;

Along across(Along along) { return along == Along::rows ? Along::columns : Along::rows; }

/// Returns the mean distance of lines.
double gap_of(const LineGrid& grid, Along along) {
  return (along == Along::rows ? grid.size().y : grid.size().x) / grid.strips(along);
}

bool is_inner(const LineGrid& grid, Along along, int line) {
  return line > 0 && line < grid.strips(along);
}

/// Returns whether a line stays where it is: on the border, along a guide or at the end of one.
bool is_fixed(const LineGrid& grid, Along along, int line) {
  if (!is_inner(grid, along, line)) return true;
  for (int k = 0; k < grid.points_along(along); ++k) {
    const LineGrid::Knot& knot = grid.knot(grid.number(along, line, k));
    if (knot.follows(along)) return true;
    if (knot.is_held() && is_inner(grid, across(along), k)) return true;
  }
  return false;
}

/// Returns whether a line can follow a guide: where the guide passes it follows no other, and is
/// held only where the guide passes too.
bool can_follow(const LineGrid& grid, Along along, int line, const Guide& guide,
                const GuideTrack& track) {
  if (!is_inner(grid, along, line)) return false;
  for (int k = 0; k < grid.points_along(along); ++k) {
    const LineGrid::Knot& knot = grid.knot(grid.number(along, line, k));
    if (!track.reaches(k)) continue;
    if (knot.follows(along)) return false;
    const bool is_near =
        glm::distance(guide.at(guide.nearest(knot.position)), knot.position) < least_gap;
    if (knot.is_held() && is_inner(grid, across(along), k) && !is_near) return false;
  }
  return true;
}

/// The nearest lines on both sides of one that stay where they are.
struct FixedLines {
  int before, after;
};

FixedLines fixed_beside(const LineGrid& grid, Along along, int line) {
  FixedLines fixed{line - 1, line + 1};
  while (!is_fixed(grid, along, fixed.before)) --fixed.before;
  while (!is_fixed(grid, along, fixed.after)) ++fixed.after;
  return fixed;
}

/// Returns how far between the lines beside it a line can be bent so that all lines have room.
TrackLimits room_of(const LineGrid& grid, Along along, int line) {
  const FixedLines fixed = fixed_beside(grid, along, line);
  const double gap = least_gap / gap_of(grid, along);
  return {fixed.before + gap * (line - fixed.before), fixed.after - gap * (fixed.after - line)};
}

/// Moves a point of a grid to where, of a line along rows or columns of the grid as it was, a line
/// passes; points on guides and on the border slide, others that are held stay.
void move_point(LineGrid& grid, const LineGrid& was, Along along, int line, int point, double to) {
  const int number = was.number(along, line, point);
  const LineGrid::Knot& knot = was.knot(number);
  if (knot.is_held() || knot.follows(along)) return;
  if (!is_inner(was, across(along), point)) {
    // Between the points of the border that are held.
    constexpr double least_share = 0.05;
    int before = line, after = line;
    while (!was.knot(was.number(along, before, point)).is_held()) --before;
    while (!was.knot(was.number(along, after, point)).is_held()) ++after;
    to = std::clamp(to, before + least_share, after - least_share);
  }
  const glm::dvec2 place =
      place_at(was, along == Along::rows ? glm::dvec2(point, to) : glm::dvec2(to, point));
  const LineGrid::OnGuide& on = knot.on_guide(across(along));
  if (on.guide >= 0)
    grid.put_on_guide(number, across(along),
                      {on.guide, was.guides()[std::size_t(on.guide)].nearest(place)});
  else
    grid.knot(number).position = place;
}

/// Returns the grid with a line bent so that each of its points lies where a line of this number,
/// as a real number, lay; the lines beside it, up to those that are fixed, make room.
LineGrid bent(const LineGrid& grid, Along along, int line, const std::vector<double>& to) {
  const FixedLines fixed = fixed_beside(grid, along, line);
  LineGrid result = grid;
  for (int i = fixed.before + 1; i < fixed.after; ++i)
    for (int k = 0; k < grid.points_along(along); ++k) {
      const int end = i <= line ? fixed.before : fixed.after;
      const double share = double(i - end) / (line - end);
      move_point(result, grid, along, i, k, std::lerp(double(end), to[std::size_t(k)], share));
    }
  return result;
}

/// Returns where the points of a line are to be that follows a track: on it, and back on the line
/// some points beyond its ends.
std::vector<double> bend_along(const LineGrid& grid, Along along, int line,
                               const GuideTrack& track) {
  constexpr double reach = 3;
  std::vector<double> to;
  for (int k = 0; k < grid.points_along(along); ++k) {
    const LineGrid::Knot& knot = grid.knot(grid.number(along, line, k));
    const double beyond = std::max({0.0, track.first().point - k, k - track.last().point});
    const double left = std::max(0.0, 1 - beyond / reach);
    const double share = knot.follows(along) ? 0 : left * left * (3 - 2 * left);
    to.push_back(std::lerp(double(line), track.at(k).line, share));
  }
  return to;
}

/// Puts a point of a line on the guide that the line follows, and holds it where the line follows
/// another guide there or ends at the border. Leaves it where the guide is elsewhere.
void follow(LineGrid& grid, Along along, int number, const LineGrid::OnGuide& on,
            bool is_on_border) {
  const LineGrid::Knot before = grid.knot(number);
  const Guide& guide = grid.guides()[std::size_t(on.guide)];
  const LineGrid::OnGuide other = before.on_guide(across(along));
  if (is_on_border || before.is_held()) {
    constexpr double last_bits = 1e-6;
    const double way = guide.nearest(before.position);
    const double gap = glm::distance(guide.at(way), before.position);
    if (gap > (is_on_border ? last_bits : least_gap)) return;
    grid.knot(number).on_guide(along) = {on.guide, way};
  } else if (other.guide >= 0) {
    const auto ways = guide.crossing(grid.guides()[std::size_t(other.guide)], before.position);
    if (!ways) return;
    grid.put_on_guide(number, across(along), {other.guide, ways->second});
    grid.put_on_guide(number, along, {on.guide, ways->first});
  } else {
    grid.put_on_guide(number, along, on);
    return;
  }
  grid.knot(number).ways = 0;
}

bool can_have_line(const LineGrid& grid, Along along, int points) {
  return grid.points() + grid.points_along(along) <= points;
}

/// A line of a grid that may be moved to where it is wanted.
struct FreeLine {
  LineGrid grid;
  int line;
};

/// Returns the line nearest to `at`, as a real number, if it is free; else a new one, or the next
/// one where there is no room for that. Nothing if that is not free either.
std::optional<FreeLine> free_line(const LineGrid& grid, Along along, double at, int points,
                                  const std::function<bool(int)>& is_free) {
  const int strip = clamped_int(at, 0, grid.strips(along) - 1);
  const int nearest = clamped_int(at + 0.5, strip, strip + 1), next = 2 * strip + 1 - nearest;
  if (is_free(nearest)) return FreeLine{grid, nearest};
  if (can_have_line(grid, along, points)) return FreeLine{grid.with_line(along, strip), strip + 1};
  return is_free(next) ? std::optional(FreeLine{grid, next}) : std::nullopt;
}

/// Brings a line across to the end of a guide and holds it there: so that the whole guide is
/// followed. Leaves the grid as it is where that is not possible.
void hold_end(LineGrid& grid, Along along, int line, const LineGrid::OnGuide& on, int points) {
  const Along other = across(along);
  const glm::dvec2 end = grid.guides()[std::size_t(on.guide)].at(on.way);
  const auto point_of = [&](const LineGrid& in) {
    const glm::dvec2 at = column_and_row(in, end).value_or(glm::dvec2(0.0));
    return along == Along::rows ? at.x : at.y;
  };
  for (int k = 0; k < grid.points_along(along); ++k) {
    const bool is_near =
        glm::distance(end, grid.knot(grid.number(along, line, k)).position) < least_gap;
    if (is_near && is_fixed(grid, other, k)) return;
  }
  const auto found = free_line(grid, other, point_of(grid), points,
                               [&](int k) { return !is_fixed(grid, other, k); });
  if (!found) return;
  const auto count = std::size_t(found->grid.points_along(other));
  LineGrid held = bent(found->grid, other, found->line, std::vector(count, point_of(found->grid)));
  const int number = held.number(along, line, found->line);
  held.put_on_guide(number, along, on);
  held.knot(number).ways = 0;
  if (!held.folds()) grid = held;
}

/// A line that is to follow a guide, and the piece of the guide that it can follow.
struct Follower {
  LineGrid grid;
  int line;
  GuideTrack track;
};

std::optional<Follower> follower_of(const LineGrid& grid, const Guide& guide, Along along,
                                    int points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const GuideTrack whole = guide_track(grid, guide, along, {-infinity, infinity});
  if (whole.is_empty()) return {};
  const auto found = free_line(grid, along, whole.mean_line(), points, [&](int line) {
    return can_follow(grid, along, line, guide, whole);
  });
  if (!found) return {};
  Follower follower{
      found->grid, found->line,
      guide_track(found->grid, guide, along, room_of(found->grid, along, found->line))};
  if (follower.track.is_empty()) return {};
  return follower;
}

/// Returns the grid with a line along rows or columns that follows a guide; nothing if it cannot.
std::optional<LineGrid> with_guide(const LineGrid& grid, const Guide& whole, Along along,
                                   int points) {
  auto found = follower_of(grid, whole, along, points);
  if (!found) return {};
  const GuideTrack& track = found->track;
  const Guide guide = whole.piece(track.first().way, track.last().way);
  if (guide.length() < 2 * least_gap) return {};
  const int line = found->line;
  LineGrid result = bent(found->grid, along, line, bend_along(found->grid, along, line, track));
  const int number = result.add_guide(guide);
  for (int k = 0; k < result.points_along(along); ++k) {
    if (!track.reaches(k)) continue;
    const double way = std::abs(track.at(k).way - track.first().way);
    const bool is_on_border = !is_inner(result, across(along), k);
    follow(result, along, result.number(along, line, k), {number, way}, is_on_border);
  }
  if (result.folds()) return {};
  hold_end(result, along, line, {number, 0}, points);
  hold_end(result, along, line, {number, guide.length()}, points);
  for (int k = 0; k < result.points_along(along); ++k)
    if (result.knot(result.number(along, line, k)).on_guide(along).guide == number) return result;
  return {};
}

/// Returns the direction along which a guide is longer.
Along direction_of(const std::vector<glm::dvec2>& line) {
  glm::dvec2 low = line.front(), high = low;
  for (const glm::dvec2 point : line) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  return high.x - low.x >= high.y - low.y ? Along::rows : Along::columns;
}

bool is_line(const std::vector<glm::dvec2>& points) {
  const bool is_finite = std::ranges::all_of(
      points, [](glm::dvec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); });
  return is_finite &&
         std::ranges::any_of(points, [&](glm::dvec2 p) { return p != points.front(); });
}

}  // namespace

GuidedGrid guided_grid(const LineGrid& grid, const std::vector<std::vector<glm::dvec2>>& guides,
                       int points) {
  GuidedGrid result{grid};
  for (std::size_t n = 0; n < guides.size(); ++n) {
    std::optional<LineGrid> guided;
    if (is_line(guides[n])) {
      const Guide guide(guides[n]);
      const Along along = direction_of(guides[n]);
      guided = with_guide(result.grid, guide, along, points);
      if (!guided) guided = with_guide(result.grid, guide, across(along), points);
    }
    if (guided)
      result.grid = *std::move(guided);
    else
      result.unused.push_back(n);
  }
  return result;
}

}  // namespace gradmesh
