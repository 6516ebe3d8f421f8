#include "app/document/weighted_shapes.h"

#include <sstream>
#include <stdexcept>

#include "metric/metric.h"

namespace gradmesh {

std::vector<WeightedArea> weighted_shapes(const Document& document, const ShapeWeights& weights,
                                          const Affine& from_document) {
  std::vector<WeightedArea> areas;
  for (const auto& [id, factor] : weights) {
    if (!(factor >= least_weight && factor <= most_weight)) {
      std::ostringstream text;
      text << "the weight of " << id << " must be between " << least_weight << " and "
           << most_weight << ".";
      throw std::invalid_argument(text.str());
    }
    WeightedArea& area = areas.emplace_back(WeightedArea{document.covered({id}), factor});
    for (FilledOutline& shape : area.shapes)
      shape.outline = mapped(std::move(shape.outline), from_document);
  }
  return areas;
}

}  // namespace gradmesh
