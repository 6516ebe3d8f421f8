#include "trace/guide_track.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/clamped_int.h"
#include "trace/grid_map.h"

namespace gradmesh {
namespace {

using Place = GuideTrack::Place;

std::optional<Place> place_of(const LineGrid& grid, const Guide& guide, Along along, double way) {
  const auto at = column_and_row(grid, guide.at(way));
  if (!at) return {};
  return along == Along::rows ? Place{way, at->x, at->y} : Place{way, at->y, at->x};
}

/// Returns where between two ways, of which the first is in the grid and the second is not, the
/// guide leaves it.
Place border_place(const LineGrid& grid, const Guide& guide, Along along, double in, double out) {
  constexpr int halvings = 50;
  for (int k = 0; k < halvings; ++k) {
    const double middle = (in + out) / 2;
    (place_of(grid, guide, along, middle) ? in : out) = middle;
  }
  return *place_of(grid, guide, along, in);
}

/// Returns the pieces of a guide in the grid as places about half a pixel apart.
std::vector<std::vector<Place>> pieces_in(const LineGrid& grid, const Guide& guide, Along along) {
  const int steps = clamped_int(2 * guide.length(), 16, 4000);
  std::vector<std::vector<Place>> pieces;
  bool was_in = false;
  double before = 0;
  for (int k = 0; k <= steps; ++k) {
    const double way = guide.length() * k / steps;
    const std::optional<Place> place = place_of(grid, guide, along, way);
    if (place && !was_in) {
      pieces.emplace_back();
      if (k > 0) pieces.back().push_back(border_place(grid, guide, along, way, before));
    }
    if (!place && was_in) pieces.back().push_back(border_place(grid, guide, along, before, way));
    if (place) pieces.back().push_back(*place);
    was_in = place.has_value();
    before = way;
  }
  return pieces;
}

double extent(const std::vector<Place>& places) {
  return places.empty() ? 0 : std::abs(places.back().point - places.front().point);
}

}  // namespace

Place GuideTrack::at(double point) const {
  const auto next = std::ranges::lower_bound(places, point, {}, &Place::point);
  if (next == places.begin()) return first();
  if (next == places.end()) return last();
  const Place &a = *(next - 1), &b = *next;
  const double share = (point - a.point) / (b.point - a.point);
  return {std::lerp(a.way, b.way, share), point, std::lerp(a.line, b.line, share)};
}

double GuideTrack::mean_line() const {
  double sum = 0;
  for (const Place& place : places) sum += place.line;
  return sum / double(places.size());
}

GuideTrack guide_track(const LineGrid& grid, const Guide& guide, Along along, TrackLimits range) {
  // What rises more steeply is for a line in the other direction.
  constexpr double flattest = 0.25;
  const bool is_row = along == Along::rows;
  const glm::dvec2 patch = grid.size() / glm::dvec2(grid.columns(), grid.rows());
  const double by_point = is_row ? patch.x : patch.y, by_line = is_row ? patch.y : patch.x;
  GuideTrack longest;
  std::vector<Place> run;
  const auto end_run = [&] {
    if (extent(run) > extent(longest.places)) longest.places = run;
    run.clear();
  };
  for (const std::vector<Place>& piece : pieces_in(grid, guide, along)) {
    double direction = 0;
    for (const Place& place : piece) {
      if (!run.empty()) {
        const double ahead = by_point * (place.point - run.back().point);
        const double aside = by_line * std::abs(place.line - run.back().line);
        const bool is_first = run.size() == 1;
        if (is_first) direction = ahead < 0 ? -1 : 1;
        if (!(direction * ahead > flattest * aside)) end_run();
      }
      if (place.line < range.low || place.line > range.high)
        end_run();
      else
        run.push_back(place);
    }
    end_run();
  }
  if (!longest.is_empty() && longest.last().point < longest.first().point)
    std::ranges::reverse(longest.places);
  return longest;
}

}  // namespace gradmesh
