#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "mesh/region.h"
#include "ops/journal.h"
#include "ops/merge/merge_region.h"
#include "trial/edit_error.h"
#include "trial/fit_trial.h"

namespace gradmesh {

/// The loop body of the paper's Fig. 3: check what is to be merged, merge it, paint, compare, and
/// keep the merge or take it back.
class MergeTrial {
 public:
  MergeTrial(Mesh& mesh, EditError error, double epsilon)
      : journal_(mesh), error_(std::move(error)), start_(error_.state()), epsilon_(epsilon) {}

  /// Merges the edge if that is possible and the whole error stays at most epsilon and keeps to
  /// the local bound.
  bool try_merge(Halfedge edge);

  /// The same for all the patches of all these regions, all or none. Regions that cannot be merged
  /// any more after the others are left out.
  bool try_merge(const std::vector<Region>& regions);

  /// Merges these edges one after another if the whole error is then at most `limit`. Returns what
  /// it is then, or would be: some number above epsilon once it is certain to be above that;
  /// infinity where one of the edges cannot be merged in its turn, or where the error is at most
  /// `limit` and breaks the local bound.
  double try_merge(const std::vector<Halfedge>& edges, double limit);
  /// The same error; nothing is merged.
  double error_with(const std::vector<Halfedge>& edges) {
    return try_merge(edges, -std::numeric_limits<double>::infinity());
  }

  /// Merges the regions whatever the error is.
  void merge(const std::vector<Region>& regions);

  /// What has been merged so far, to come back to.
  struct State {
    std::size_t depth;
    std::shared_ptr<const EditError::State> error;
  };
  State state() { return {depth(), error_.state()}; }
  /// Takes back what was merged since.
  void go_back(const State& state);
  /// Takes everything back.
  void undo_all() { go_back({0, start_}); }
  /// Takes the last merge back without a look at the error: nothing may be tried before
  /// measure_again.
  void undo_last() { journal_.undo(); }
  void measure_again();
  /// Keeps more of the error free than until now.
  void lower_epsilon(double epsilon) { epsilon_ = std::min(epsilon_, epsilon); }

  const Mesh& mesh() const { return journal_.mesh(); }
  /// Merges that can be taken back.
  std::size_t depth() const { return journal_.depth(); }
  double error() const { return error_.error(); }
  double epsilon() const { return epsilon_; }
  /// How much the error may still rise.
  double room() const { return epsilon_ - error(); }
  const EditError& measure() const { return error_; }
  /// Merges, of edges or regions, that were painted and measured, here and by all the forks.
  int evaluations() const { return error_.evaluations(); }

  /// Called with what happened when a device fails and the run goes on without.
  using DeviceLost = std::function<void(const DeviceError&)>;
  /// Many regions at once are priced on that device from now on (BatchPrices), until it is lost.
  void use_device(std::shared_ptr<Device> device, DeviceLost told) {
    device_ = std::move(device);
    device_lost_ = std::move(told);
  }
  bool has_device() const { return device_ != nullptr; }
  void lose_device(const DeviceError& error) {
    device_ = nullptr;
    if (device_lost_) device_lost_(error);
  }
  /// Throws DeviceError.
  std::unique_ptr<DeviceErrors> errors_on_device() { return error_.on_device(device_); }

  /// A mesh and a trial of its own, as they are here now, for another thread.
  struct Fork;
  std::unique_ptr<Fork> fork();
  /// The same, of a trial that goes on with fits.
  std::unique_ptr<FitTrial::Fork> fork_to_fit(std::shared_ptr<const FitTarget> target);

 private:
  friend class RegionTrial;

  /// Merges those of the regions that can be merged after the ones before them.
  void merge_possible(const std::vector<Region>& regions);
  /// Merges the edges, or as many as can be merged before one cannot; whether that is all.
  bool merge_in_turn(const std::vector<Halfedge>& edges);
  void undo_to(std::size_t depth);
  /// Keeps the operations after the first `depth`, or takes them back if they cost too much.
  bool keep_if_cheap(std::size_t depth);

  Journal journal_;
  EditError error_;
  std::shared_ptr<const EditError::State> start_;
  double epsilon_;
  std::shared_ptr<Device> device_;
  DeviceLost device_lost_;
};

/// Works out what merging single regions would cost, and leaves the trial as it was when it goes.
/// Regions that grow by rows share the merges of the rows they share (RegionMerger).
class RegionTrial {
 public:
  /// `start` is the trial's mesh as it is now, and stays so.
  RegionTrial(MergeTrial& trial, const Mesh& start)
      : trial_(trial), merger_(trial.journal_, start), depth_(trial.depth()) {}
  ~RegionTrial() { merger_.undo(); }
  RegionTrial(const RegionTrial&) = delete;
  RegionTrial& operator=(const RegionTrial&) = delete;

  /// By how much merging the region alone would raise the error; some number above `limit` where
  /// it is certain to be above that; infinity where it cannot be merged.
  double price(const Region& region, double limit = std::numeric_limits<double>::infinity());
  /// What merging the region alone paints, to be measured on a device; false where it cannot be
  /// merged.
  bool describe(const Region& region, EditTile& tile);
  /// Whether merging the region alone, which must cost at most `limit`, keeps to the local bound.
  bool keeps_local_bound(const Region& region, double limit) {
    return price(region, limit) <= limit && trial_.error_.keeps_local_bound();
  }

 private:
  MergeTrial& trial_;
  RegionMerger merger_;
  const std::size_t depth_;
};

struct MergeTrial::Fork {
  Fork(Mesh from, EditError error, double epsilon)
      : mesh(std::move(from)), trial(mesh, std::move(error), epsilon) {}

  Mesh mesh;
  MergeTrial trial;
};

}  // namespace gradmesh
