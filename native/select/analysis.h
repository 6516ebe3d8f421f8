#pragma once

#include <cstdint>
#include <map>

#include "error/merge_trial.h"
#include "mesh/mesh.h"
#include "mesh/region.h"
#include "metric/metric.h"
#include "raster/frame.h"

namespace gradmesh {

/// What the prices of an analysis depend on.
struct AnalysisKey {
  /// Hash of the original mesh, whose picture counts.
  std::uint64_t original = 0;
  /// Hash of the mesh that is merged, and of where it lies in the frame.
  std::uint64_t content = 0;
  MetricKind metric = MetricKind::flip;
  /// Size of the frame in pixels.
  int width = 0, height = 0;
  ColorModel color_model = ColorModel::bilinear;

  bool operator==(const AnalysisKey&) const = default;
};

AnalysisKey analysis_key(const Mesh& original, const Mesh& mesh, const Frame& frame,
                         MetricKind metric);

/// What merging single regions of a mesh costs: the preprocessing of the paper's 6.2 and 6.3 (B.3).
/// An edge is the region of its two patches. It depends on neither epsilon nor omega nor kappa,
/// and whoever needs a price that is not there yet adds it.
struct Analysis {
  AnalysisKey key;
  /// By how much merging the region alone raises the error; infinity: it cannot be merged. Keys as
  /// of region_name.
  std::map<Region, double> prices;
};

/// The price of a region, by its name, from the analysis or else tried and added to it.
double price(MergeTrial& trial, Analysis& analysis, const Region& name);

}  // namespace gradmesh
