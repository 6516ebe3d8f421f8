#pragma once

#include <functional>
#include <optional>

#include "base/progress.h"
#include "fit/target.h"
#include "form/counts.h"
#include "plain/plain_grid.h"

namespace gradmesh {

/// What a grid with fewer handles must keep to, and how that is found out.
struct GridTask {
  /// The picture of the original, in the frame in which the error is measured.
  const FitTarget& picture;
  /// The same in a smaller frame: enough to tell which sides are cheaper than others.
  const FitTarget& coarse_picture;
  struct Measured {
    double error;
    /// The largest error of a small part, as a share of the local bound; 0 if there is none.
    double local;
    /// True if the error is at most epsilon and the grid keeps to the local bound.
    bool keeps;
  };
  /// Measures a grid as it will be written. Called from several threads at once.
  std::function<Measured(const PlainGrid&)> measure;
  double epsilon;
  /// Ends the selection once it is reached; nothing if epsilon alone does.
  std::optional<Target> target = std::nullopt;
};

struct SimplerGrid {
  PlainGrid grid;
  /// The error that was measured last, of this grid.
  double error;
  /// The number of grids that were fitted and measured.
  int evaluations;
};

/// Takes handles out of a grid as long as it keeps to the task: sides are made straight, many at
/// once while they are cheap, and whole lines of points are taken out. What costs least for each
/// handle comes first, and all points are fitted to the picture after each step, so that lines come
/// to stand elsewhere than any did before. Returns nothing if the grid without twists cannot be
/// fitted so that it keeps to the task, or if no handle can be taken out.
std::optional<SimplerGrid> with_fewer_handles(const PlainGrid& grid, const GridTask& task,
                                              StopWatch& watch);

}  // namespace gradmesh
