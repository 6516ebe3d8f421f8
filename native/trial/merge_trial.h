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

  /// Merges the edge if that is possible, and if the whole error stays at most epsilon and keeps to
  /// the local bound. Returns true if the edge was merged.
  bool try_edge(Halfedge edge);

  /// Merges all these regions or none, on the same conditions. Regions that cannot be merged any
  /// more after the others are left out.
  bool try_regions(const std::vector<Region>& regions);

  /// Merges these edges one after another if the whole error is then at most `limit`. Returns the
  /// error that the mesh then has, or would have: some number above epsilon once the error is
  /// certain to be above epsilon; infinity if one of the edges cannot be merged in its turn, or if
  /// the error is at most `limit` but breaks the local bound.
  double try_edges(const std::vector<Halfedge>& edges, double limit);
  /// Returns the error that the mesh would have, as try_edges does but regardless of the local
  /// bound. Merges nothing.
  double error_with(const std::vector<Halfedge>& edges) {
    return try_edges(edges, -std::numeric_limits<double>::infinity());
  }

  /// Merges those of the regions that can be merged in their turn, whatever the error is.
  void merge(const std::vector<Region>& regions);

  /// A state of the trial, to go back to.
  struct State {
    std::size_t depth;
    std::shared_ptr<const EditError::State> error;
  };
  State state() { return {depth(), error_.state()}; }
  /// Takes back what was merged since that state.
  void go_back(const State& state);
  /// Takes everything back.
  void undo_all() { go_back({0, start_}); }
  /// Takes the last merge back without measuring the error: nothing may be tried before
  /// measure_again.
  void undo_last() { journal_.undo(); }
  void measure_again();
  /// Lowers epsilon; a value above the present one changes nothing.
  void lower_epsilon(double epsilon) { epsilon_ = std::min(epsilon_, epsilon); }

  const Mesh& mesh() const { return journal_.mesh(); }
  /// Returns the number of merges that can be taken back.
  std::size_t depth() const { return journal_.depth(); }
  double error() const { return error_.error(); }
  double epsilon() const { return epsilon_; }
  /// Returns how much the error may still rise.
  double room() const { return epsilon_ - error(); }
  const EditError& measure() const { return error_; }
  /// Returns the number of merges, of edges or regions, that were painted and measured, here and by
  /// all the forks.
  int evaluations() const { return error_.evaluations(); }

  /// Called with the error when a device fails and the run goes on without it.
  using DeviceLost = std::function<void(const DeviceError&)>;
  /// Lets many regions at once be priced on that device from now on (BatchPrices), until it is
  /// lost.
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

  /// A copy of the mesh and of the trial as they are now, for another thread.
  struct Fork;
  std::unique_ptr<Fork> fork();
  /// Returns such a copy as a trial that goes on with fits (FitTrial).
  std::unique_ptr<FitTrial::Fork> fork_to_fit(bool keeps_plain = false);

 private:
  friend class RegionTrial;

  /// Merges those of the regions that can be merged after the ones before them.
  void merge_possible(const std::vector<Region>& regions);
  /// Merges the edges in order until one cannot be merged. Returns true if all were merged.
  bool merge_in_turn(const std::vector<Halfedge>& edges);
  /// Keeps the operations after the first `depth`, or takes them back if they cost too much.
  /// Returns true if they were kept.
  bool keep_if_cheap(std::size_t depth);

  Journal journal_;
  EditError error_;
  std::shared_ptr<const EditError::State> start_;
  double epsilon_;
  std::shared_ptr<Device> device_;
  DeviceLost device_lost_;
};

/// Works out what merging single regions would cost, and leaves the trial as it was when it is
/// destroyed. Regions that grow by rows share the merges of common rows (RegionMerger).
class RegionTrial {
 public:
  /// `start` is a copy of the trial's mesh as it is now, and must not change.
  RegionTrial(MergeTrial& trial, const Mesh& start)
      : trial_(trial), merger_(trial.journal_, start), depth_(trial.depth()) {}
  ~RegionTrial() { merger_.undo(); }
  RegionTrial(const RegionTrial&) = delete;
  RegionTrial& operator=(const RegionTrial&) = delete;

  /// Returns by how much merging the region alone would raise the error; some number above `limit`
  /// once the rise is certain to be above `limit`; infinity if the region cannot be merged.
  double price(const Region& region, double limit = std::numeric_limits<double>::infinity());
  /// Describes what merging the region alone paints, to be measured on a device. Returns false if
  /// the region cannot be merged.
  bool describe(const Region& region, EditTile& tile);
  /// Returns true if merging the region alone costs at most `limit` and keeps to the local bound.
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
