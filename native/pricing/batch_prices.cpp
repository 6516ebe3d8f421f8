#include "pricing/batch_prices.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gradmesh {
namespace {

/// Number of chains that are described while the device measures those before.
constexpr std::size_t chains_at_once = 256;
/// Most pixels of the tiles that are measured at once, unless a single tile has more.
constexpr std::size_t most_pixels = std::size_t(1) << 22;
/// Distance of an error from the limit up to which the device and the software path could decide
/// differently.
constexpr double rounding = 1e-4;

std::size_t pixels_of(const EditTile& tile) {
  return std::size_t(tile.window.width()) * std::size_t(tile.window.height());
}

}  // namespace

BatchPrices::BatchPrices(MergeTrial& trial, ParallelTrials<MergeTrial>& trials, const Mesh& mesh)
    : trials_(trials),
      mesh_(mesh),
      device_(trial.errors_on_device()),
      pixels_(double(trial.measure().pixels())) {}

bool BatchPrices::price(std::vector<PricedChain>& chains, double limit,
                        const std::function<bool(std::size_t done)>& stop) {
  std::size_t done = 0;
  while (done < chains.size() && !stop(done)) {
    const std::size_t end = std::min(chains.size(), done + chains_at_once);
    submit(describe(chains, done, end), chains);
    done = end;
  }
  collect(chains);
  price_again(chains, limit);
  return done == chains.size();
}

std::vector<BatchPrices::Edit> BatchPrices::describe(std::vector<PricedChain>& chains,
                                                     std::size_t begin, std::size_t end) {
  std::vector<std::vector<Edit>> of_chains(end - begin);
  trials_.for_each(
      of_chains.size(), [](std::size_t) { return false; },
      [&](MergeTrial& own, std::size_t i) {
        RegionTrial trial(own, mesh_);
        PricedChain& chain = chains[begin + i];
        for (std::size_t k = 0; k < chain.regions.size(); ++k) {
          Edit edit{{}, begin + i, k};
          if (trial.describe(chain.regions[k], edit.tile))
            of_chains[i].push_back(std::move(edit));
          else
            chain.errors[k] = std::numeric_limits<double>::infinity();
        }
      });
  std::vector<Edit> edits;
  for (std::vector<Edit>& of_chain : of_chains)
    std::ranges::move(of_chain, std::back_inserter(edits));
  return edits;
}

void BatchPrices::submit(std::vector<Edit> edits, std::vector<PricedChain>& chains) {
  std::vector<EditTile> tiles;
  for (std::size_t next = 0; next < edits.size();) {
    collect(chains);
    tiles.clear();
    for (std::size_t pixels = 0; next < edits.size(); ++next) {
      pixels += pixels_of(edits[next].tile);
      if (pixels > most_pixels && !tiles.empty()) break;
      submitted_.emplace_back(edits[next].chain, edits[next].region);
      tiles.push_back(std::move(edits[next].tile));
    }
    device_->submit(tiles);
  }
}

void BatchPrices::collect(std::vector<PricedChain>& chains) {
  if (submitted_.empty()) return;
  const std::vector<double> rises = device_->rises();
  for (std::size_t i = 0; i < submitted_.size(); ++i) {
    const auto [chain, region] = submitted_[i];
    chains[chain].errors[region] = rises[i] / pixels_;
  }
  submitted_.clear();
}

void BatchPrices::price_again(std::vector<PricedChain>& chains, double limit) {
  const auto is_close = [&](const std::optional<double>& error) {
    return error && std::abs(*error - limit) <= rounding;
  };
  std::vector<std::size_t> close;
  for (std::size_t i = 0; i < chains.size(); ++i)
    if (std::ranges::any_of(chains[i].errors, is_close)) close.push_back(i);
  trials_.for_each(
      close.size(), [](std::size_t) { return false; },
      [&](MergeTrial& own, std::size_t i) {
        RegionTrial trial(own, mesh_);
        PricedChain& chain = chains[close[i]];
        for (std::size_t k = 0; k < chain.regions.size(); ++k)
          if (is_close(chain.errors[k])) chain.errors[k] = trial.price(chain.regions[k]);
      });
}

}  // namespace gradmesh
