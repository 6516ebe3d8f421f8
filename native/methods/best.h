#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "methods/regions.h"
#include "trial/merge_trial.h"

namespace gradmesh {

/// What merge_and_fit needs to know beside the mesh.
struct FitContext {
  std::shared_ptr<const FitTarget> target;
  /// The error of a mesh as it will be written, on the whole frame, and whether that keeps to
  /// epsilon and to the local bound.
  struct Written {
    double error;
    bool keeps;
  };
  std::function<Written(const Mesh&)> written;
  /// Weight of a region's size against its error, as of gqe.
  double omega = 0.75;
};

struct FittedMesh {
  Mesh mesh;
  /// Error of the mesh, added up from what single edits changed.
  double error = 0;
};

/// Goes on where gqe ends. Fitting a merged mesh to the picture lowers its error, often to less
/// than half: so sets of regions that together cost more than epsilon are merged as well, if they
/// keep to it once fitted. From the best of them, or from what gqe merged, merging goes on in
/// rounds, each priced, merged and fitted on the mesh as it then is, until nothing more keeps to
/// epsilon.
///
/// `start` is the mesh before anything was merged, `regions` those of price_regions there, and
/// `merged` what gqe made of them; all stay as they are. Returns the mesh with the fewest patches
/// that, as it will be written, keeps to epsilon and to the local bound; none where that is not
/// fewer than at the start. Never more than `merged`, if that keeps to them.
std::optional<FittedMesh> merge_and_fit(MergeTrial& start, MergeTrial& merged,
                                        const std::vector<RegionPrice>& regions,
                                        const FitContext& context, StopWatch& watch);

/// The same rounds from what gqe merged, whatever else there is.
std::optional<FittedMesh> fit(MergeTrial& merged, const FitContext& context, StopWatch& watch);

/// By how much each of the regions raises the error where it alone is merged and its patch fitted,
/// in their order: at most its price, which must be at most `limit`. The price itself for those
/// that `watch` leaves no time for.
std::vector<double> fitted_prices(FitTrial& trial, const std::vector<RegionPrice>& regions,
                                  double limit, StopWatch& watch);

}  // namespace gradmesh
