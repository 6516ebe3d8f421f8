#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mesh/mesh.h"
#include "methods/merging/edges.h"
#include "methods/merging/regions.h"
#include "metric/metric.h"
#include "raster/frame.h"
#include "reference/original.h"

namespace gradmesh {

/// A mesh as a page shows it.
struct PageMesh {
  /// Name of the file on the page.
  std::string file;
  Mesh mesh;
  /// Both meshes of a page have frames of one size.
  Frame frame;
  /// The number of objects that paint the mesh in its document.
  int objects = 1;
};

/// A mesh before and after its simplification, and what is known about it.
struct Page {
  /// Name of the mesh on the page.
  std::string id;
  PageMesh before, after;
  /// What has the picture that counts, in the frame of `before`.
  std::shared_ptr<const Original> original;
  MetricKind metric = MetricKind::flip;
  /// Prices of the mesh before.
  std::vector<EdgePrice> edges;
  std::vector<RegionPrice> regions;
  /// Prices of the regions once fitted, in their order; empty if not worked out.
  std::vector<double> fitted;
  /// The error up to which regions were priced.
  double epsilon = 0;
  /// The result of the simplification, an object of names and values; null if not known.
  nlohmann::ordered_json run;
};

/// Returns one page of HTML in UTF-8 that needs no other files: both pictures, the error map, the
/// patches and how they are connected (B.1), the regions (B.3), the counts and the options.
std::string page_html(const Page& page);

}  // namespace gradmesh
