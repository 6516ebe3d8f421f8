#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mesh/mesh.h"
#include "methods/edges.h"
#include "methods/regions.h"
#include "metric/metric.h"
#include "raster/frame.h"

namespace gradmesh {

/// A mesh as a report shows it.
struct ReportedMesh {
  /// What the page calls its file.
  std::string file;
  Mesh mesh;
  /// Both meshes of a report have frames of one size.
  Frame frame;
};

/// A mesh before and after its simplification, and what is known about it.
struct Report {
  /// What the page calls the mesh.
  std::string id;
  ReportedMesh before, after;
  /// Whose picture counts, in the frame of `before`, where that is not `before` itself.
  const Mesh* original = nullptr;
  MetricKind metric = MetricKind::flip;
  /// Prices of the mesh before.
  std::vector<EdgePrice> edges;
  std::vector<RegionPrice> regions;
  /// What the regions cost once fitted, in their order; empty: not worked out.
  std::vector<double> fitted;
  /// The error up to which regions were priced.
  double epsilon = 0;
  /// What the simplification said of itself, an object of names and values; null: not known.
  nlohmann::ordered_json run;
};

/// One page of HTML that needs nothing beside itself: both pictures, the error map, the patches
/// and how they hang together (B.1), the regions (B.3), the counts and the options. UTF-8.
std::string report_html(const Report& report);

}  // namespace gradmesh
