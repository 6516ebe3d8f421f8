#include "pricing/price_table.h"

#include <cmath>

#include "base/hash.h"
#include "mesh/mesh_hash.h"
#include "raster/hidden.h"

namespace gradmesh {
namespace {

void add(Hash& hash, const HiddenPixels& hidden, int height) {
  for (int y = 0; y < height; ++y)
    for (const HiddenPixels::Run run : hidden.row(y)) {
      hash.add(y);
      hash.add(run.begin);
      hash.add(run.end);
    }
}

void add(Hash& hash, const Plane& weights) {
  for (const float weight : weights.samples) hash.add(double(weight));
}

}  // namespace

PriceTableKey analysis_key(const Original& original, const Mesh& mesh, const Frame& frame,
                           MetricKind metric) {
  Hash content;
  add(content, mesh);
  for (const glm::dvec2 p : {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)})
    for (int i = 0; i < 2; ++i) content.add(frame.to_pixels.point(p)[i]);
  if (frame.hidden) add(content, *frame.hidden, frame.height);
  if (frame.weights) add(content, *frame.weights);
  return {original.hash(), content.value(), metric, frame.width, frame.height, mesh.color_model()};
}

Price find_price(RegionTrial& trial, const Region& region, double limit) {
  const double error = trial.price(region, limit);
  return {error, error <= limit || std::isinf(error)};
}

}  // namespace gradmesh
