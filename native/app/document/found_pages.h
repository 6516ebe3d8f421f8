#pragma once

#include <string>
#include <vector>

#include "base/message.h"

namespace gradmesh {

/// What was found of a mesh of a page.
struct FoundMesh {
  std::string id;
  /// Numbers of the page, and of the mesh among those that the page paints, from 1; the type of its
  /// shading, 4 to 7 (ISO 32000-1, 8.7.4.5).
  int page = 0, number = 0, type = 0;
  /// How many patches the page has of it, and handles, if all of these were joined.
  int patches = 0, handles = 0;
  /// Rows and columns of the grid that it became; 0 for a mesh with T-junctions.
  int rows = 0, columns = 0;
  /// Whether patches of the page were taken together, and whether colours are smooth.
  bool is_joined = false, is_smooth = false;
  /// Whether its grid is that which Illustrator keeps for itself beside the page.
  bool is_from_record = false;
  /// How many shadings of the page it is, which are the tiles of one surface.
  int shadings = 1;
  /// FLIP between the page's own patches and the mesh, both painted with 700 pixels along the
  /// longer side.
  double difference = 0;
};

/// What was found of all pages that were read.
struct FoundPages {
  /// What the document is, as JSON has it: "pdf" or "postscript".
  std::string kind = "pdf";
  std::vector<FoundMesh> meshes;
  /// A sentence for all that was not read, or not all of it.
  std::vector<Message> left_out;
  /// Whether it was stopped, so that there may be more meshes, or no one at all.
  bool is_stopped = false;
};

}  // namespace gradmesh
