#pragma once

#include <vector>

#include "trace/line_grid.h"

namespace gradmesh {

/// A piece of a guide that a line of a grid along rows or columns can follow: the lines across it
/// meet it one after the other, none at too small an angle.
struct GuideTrack {
  /// A place of the guide: how far along the lines it lies, in points of these, and at which of
  /// them, both as real numbers.
  struct Place {
    double way, point, line;
  };
  /// In the order of the points. None if the guide has no such piece.
  std::vector<Place> places;

  bool is_empty() const { return places.size() < 2; }
  const Place& first() const { return places.front(); }
  const Place& last() const { return places.back(); }
  bool reaches(double point) const {
    constexpr double last_bits = 1e-6;
    return point >= first().point - last_bits && point <= last().point + last_bits;
  }
  /// Returns where the guide passes a point; its end beyond these.
  Place at(double point) const;
  /// Returns the mean of the lines.
  double mean_line() const;
};

/// The lines between which a track is to stay, as real numbers.
struct TrackLimits {
  double low, high;
};

/// Returns the longest such piece of a guide that lies in the grid and between two lines.
GuideTrack guide_track(const LineGrid& grid, const Guide& guide, Along along, TrackLimits range);

}  // namespace gradmesh
