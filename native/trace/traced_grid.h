#pragma once

#include <functional>
#include <vector>

#include "base/progress.h"
#include "trace/line_grid.h"
#include "trace/target_picture.h"

namespace gradmesh {

/// A grid with which a trace begins, and the picture that it is to look like. Where lines end up
/// depends on where the first ones were, so more than one beginning is tried.
struct Beginning {
  const TargetPicture* target;
  LineGrid grid;
  /// Returns true if a grid is close enough to the picture, which then is not followed further, and
  /// of whose lines those are taken out that it does not need. Nothing for what is no difference in
  /// whole levels.
  std::function<bool(const LineGrid&)> is_enough = {};
  /// How many times its squares count where it is compared with others: below 1 for a grid that is
  /// nicer to edit.
  double counts = 1;
};

/// Returns even grids for a target over (0, 0) to `size`, of few, about square patches and at most
/// `points` points.
std::vector<LineGrid> even_grids(const TargetPicture& target, glm::dvec2 size, int points);

/// What became of a beginning.
struct TracedGrid {
  LineGrid grid;
  /// Which one it was.
  std::size_t beginning;
  /// The sum of the squares that is left (patch_squares).
  double squares;
  bool is_enough;
  /// As of its beginning.
  double counts;
};

/// Returns the grid of at most `points` points, 4 or more, that came of the beginnings and is the
/// best: of the fewest points if one is enough, else the closest to its picture. Colours are in
/// whole levels. In every beginning lines are put in one after the other where they gain most, on
/// smaller pictures; the two that are most promising then are finished: fitted on the whole
/// picture, with lines exchanged and taken out. Where the watch stops it, returns the best grid so
/// far. That grid is the one whose numbers the watch is told, and with which `tell` is called,
/// again and again, unless it is empty: a person sees what a stop would keep, not what is tried.
TracedGrid traced_grid(const std::vector<Beginning>& beginnings, int points, StopWatch& watch,
                       const std::function<void(const LineGrid&)>& tell = {});

}  // namespace gradmesh
