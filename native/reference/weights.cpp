#include "reference/weights.h"

#include <algorithm>

#include "raster/hidden.h"

namespace gradmesh {
namespace {

/// Gives the pixels of row y that lie between the runs the value `factor`.
void fill_between(const std::vector<HiddenPixels::Run>& runs, int y, float factor, Plane& weights) {
  int begin = 0;
  for (const HiddenPixels::Run run : runs) {
    fill(weights, {begin, y, run.begin, y + 1}, factor);
    begin = run.end;
  }
  fill(weights, {begin, y, weights.width, y + 1}, factor);
}

}  // namespace

std::shared_ptr<const Plane> weights_in(const Frame& frame,
                                        const std::vector<WeightedArea>& areas) {
  if (areas.empty()) return nullptr;
  const auto weights = std::make_shared<Plane>(frame.width, frame.height, 1.0F);
  for (const auto& [shapes, factor] : areas) {
    const HiddenPixels beyond({{shapes}}, frame);
    for (int y = 0; y < frame.height; ++y) fill_between(beyond.row(y), y, float(factor), *weights);
  }
  const bool counts_once =
      std::ranges::all_of(weights->samples, [](float weight) { return weight == 1; });
  return counts_once ? nullptr : weights;
}

}  // namespace gradmesh
