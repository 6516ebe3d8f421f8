#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/document/document.h"
#include "base/affine.h"
#include "reference/weights.h"

namespace gradmesh {

/// Ids of shapes of a document, and how many times errors count in what they cover.
using ShapeWeights = std::vector<std::pair<std::string, double>>;

/// Returns what these shapes cover, mapped from units of the document. Throws InputError if there
/// is no such shape, and std::invalid_argument if a weight is not within least_weight and
/// most_weight (metric/metric.h).
std::vector<WeightedArea> weighted_shapes(const Document& document, const ShapeWeights& weights,
                                          const Affine& from_document);

}  // namespace gradmesh
