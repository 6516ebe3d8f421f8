#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "form/counts.h"
#include "methods/regions.h"
#include "trial/merge_trial.h"

namespace gradmesh {

/// Input of merge_and_fit beside the mesh.
struct FitContext {
  std::shared_ptr<const FitTarget> target;
  /// The error of a mesh as it will be written, in the whole frame, and whether the mesh then keeps
  /// to epsilon and to the local bound.
  struct Written {
    double error;
    bool keeps;
    /// How much a person then has to handle: handles, and these with objects for as many as they
    /// are worth.
    int handles = 0, to_handle = 0;
  };
  std::function<Written(const Mesh&)> written;
  /// Weight of a region's size against its error, as in gqe.
  double omega = 0.75;
  double epsilon = 0;
  /// What is made few. Where that is handles, what is plain stays so while regions are merged
  /// (Plainness), up to this share of epsilon, and the mesh is made plainer with what is left.
  Count count = Count::patches;
  double share = 1;
};

struct FittedMesh {
  Mesh mesh;
  /// Error of the mesh, as the sum of the changes by single edits.
  double error = 0;
};

/// Merges and fits from where gqe ends. Fitting a merged mesh to the picture lowers its error,
/// often to less than half: so sets of regions that together cost more than epsilon are merged as
/// well, if they keep to epsilon once fitted. From the best of these sets, or from the mesh that
/// gqe merged, merging goes on in rounds, each priced, merged and fitted on the mesh as it then is,
/// until nothing more keeps to epsilon.
///
/// `start` is the mesh before anything was merged, `regions` are those of price_regions there, and
/// `merged` is the mesh that gqe made with them; all stay as they are. Returns the mesh with the
/// fewest patches that, as it will be written, keeps to epsilon and to the local bound; nothing if
/// it has no fewer patches than the mesh at the start. It never has more patches than `merged`, if
/// that keeps to both. Where handles are made few, returns the plainest mesh, whatever its patches.
std::optional<FittedMesh> merge_and_fit(MergeTrial& start, MergeTrial& merged,
                                        const std::vector<RegionPrice>& regions,
                                        const FitContext& context, StopWatch& watch);

/// Runs the same rounds from the mesh that gqe merged only.
std::optional<FittedMesh> fit(MergeTrial& merged, const FitContext& context, StopWatch& watch);

/// Returns for each of the regions, in their order, by how much the error rises if it alone is
/// merged and its patch fitted: at most its price, which must be at most `limit`. For regions that
/// `watch` leaves no time for it is the price itself.
std::vector<double> fitted_prices(FitTrial& trial, const std::vector<RegionPrice>& regions,
                                  double limit, StopWatch& watch);

}  // namespace gradmesh
