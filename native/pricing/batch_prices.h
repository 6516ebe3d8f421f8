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
/// the error; infinity: it cannot be merged; nothing: not found yet.
struct PricedChain {
  std::vector<Region> regions;
  std::vector<std::optional<double>> errors;

  explicit PricedChain(std::vector<Region> wanted)
      : regions(std::move(wanted)), errors(regions.size()) {}
  bool is_priced() const {
    return std::ranges::all_of(errors, [](const auto& error) { return error.has_value(); });
  }
};

/// Prices regions many at once: all cores merge them and say what is painted anew, and a device
/// paints and measures that meanwhile.
class BatchPrices {
 public:
  /// `trials` start from `mesh`, which stays as it is. Throws DeviceError.
  BatchPrices(MergeTrial& trial, ParallelTrials<MergeTrial>& trials, const Mesh& mesh);

  /// Prices the chains in their order, until `stop(done)` of that many says so; whether all. Errors
  /// so close to the limit that the device's roundings could decide are found by the software path,
  /// so that both keep the same regions. Throws DeviceError; what was found until then is there.
  bool price(std::vector<PricedChain>& chains, double limit,
             const std::function<bool(std::size_t done)>& stop);

 private:
  /// An edit and whose price it gives.
  struct Edit {
    EditTile tile;
    std::size_t chain, region;
  };
  /// Describes the edits of chains [begin, end), and prices what cannot be merged.
  std::vector<Edit> describe(std::vector<PricedChain>& chains, std::size_t begin, std::size_t end);
  void submit(std::vector<Edit> edits, std::vector<PricedChain>& chains);
  /// Waits for what was submitted last.
  void collect(std::vector<PricedChain>& chains);
  void price_again(std::vector<PricedChain>& chains, double limit);

  ParallelTrials<MergeTrial>& trials_;
  const Mesh& mesh_;
  std::unique_ptr<DeviceErrors> device_;
  double pixels_;
  std::vector<std::pair<std::size_t, std::size_t>> submitted_;
};

}  // namespace gradmesh
