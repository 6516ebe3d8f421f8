#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "device/device_errors.h"
#include "pricing/parallel_trials.h"
#include "trial/merge_trial.h"

namespace gradmesh {

/// Regions that share merges as they grow (RegionTrial), and by how much merging each alone raises
/// the error: infinity if it cannot be merged, nothing if the price is not found yet.
struct PricedChain {
  std::vector<Region> regions;
  std::vector<std::optional<double>> errors;

  explicit PricedChain(std::vector<Region> wanted)
      : regions(std::move(wanted)), errors(regions.size()) {}
  bool is_priced() const {
    return std::ranges::all_of(errors, [](const auto& error) { return error.has_value(); });
  }
};

/// Prices many regions at once: all cores merge them and describe what is painted anew, while a
/// device paints and measures what was described before.
class BatchPrices {
 public:
  /// `trials` start from `mesh`, which must not change. Throws DeviceError.
  BatchPrices(MergeTrial& trial, ParallelTrials<MergeTrial>& trials, const Mesh& mesh);

  /// Prices the chains in order until `stop(done)` returns true, `done` being the number priced so
  /// far. Returns true if all were priced. Errors so close to the limit that the device's roundings
  /// could decide are found by the software path, so that both keep the same regions. Throws
  /// DeviceError; the prices found until then stay in the chains.
  bool price(std::vector<PricedChain>& chains, double limit,
             const std::function<bool(std::size_t done)>& stop);

 private:
  /// An edit and the region whose price it gives.
  struct Edit {
    EditTile tile;
    std::size_t chain, region;
  };
  /// Describes the edits of chains [begin, end). Regions that cannot be merged get the price
  /// infinity.
  std::vector<Edit> describe(std::vector<PricedChain>& chains, std::size_t begin, std::size_t end);
  void submit(std::vector<Edit> edits, std::vector<PricedChain>& chains);
  /// Waits for the edits submitted last and stores their prices.
  void collect(std::vector<PricedChain>& chains);
  void price_again(std::vector<PricedChain>& chains, double limit);

  ParallelTrials<MergeTrial>& trials_;
  const Mesh& mesh_;
  std::unique_ptr<DeviceErrors> device_;
  double pixels_;
  std::vector<std::pair<std::size_t, std::size_t>> submitted_;
};

}  // namespace gradmesh
