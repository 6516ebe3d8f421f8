#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "app/editing/patch_choice.h"
#include "simplify/options.h"

namespace gradmesh {

struct UpdateReport;

/// Edits of single patches and points, as a person asks for them. All throw InputError; the
/// document is then unchanged.

/// How the error in the label is measured.
struct MeasureOptions {
  MetricKind metric = MetricKind::flip;
  int resolution = usual_resolution;
};

struct EditReport {
  /// Id of the mesh.
  std::string id;
  MeshCounts before, after;
  /// The number of objects that paint the mesh afterwards.
  int objects = 0;
  /// Error against the original (known_original), or else against the mesh as it was.
  double error = 0;
};

/// Merges the chosen patches, which are of one mesh, to one patch. An id alone names a block, as
/// all of a mesh is hardly ever meant.
EditReport merge(Document& document, const PatchChoice& choice, const MeasureOptions& measure = {});

struct RefineOptions {
  /// True if patches are cut by a line from left to right (rows), from top to bottom (columns).
  bool rows = true, columns = true;
  /// Where the lines lie, from the top and from the left of each patch, above 0 and below 1.
  double place = 0.5;
  /// True if the lines go on across the whole mesh.
  bool whole = false;
};

/// Splits the chosen patches exactly.
EditReport refine(Document& document, const PatchChoice& choice, const RefineOptions& options,
                  const MeasureOptions& measure = {});

/// Points of a mesh, and patches around them.
struct PointChoice {
  /// The mesh; nothing for the only one of the document.
  std::string id = {};
  /// By their numbers, as drawings tell them; no patches for all around the points.
  std::vector<int> points = {}, patches = {};
};

/// Gives the chosen patches a colour, (r, g, b), 0..1, at the points (ops/color.h). Opacities stay.
/// Later runs measure against the mesh with these colours.
EditReport recolor(Document& document, const PointChoice& choice, const glm::dvec3& color,
                   const MeasureOptions& measure = {});

/// Gives all patches around each of the points one colour there again.
EditReport join_colors(Document& document, const PointChoice& choice,
                       const MeasureOptions& measure = {});

/// Makes the selected meshes that are simplified fit together again if a person has edited their
/// blocks (SvgDocument::update). Throws also if the document is none of SVG.
std::vector<UpdateReport> update(Document& document, const std::vector<std::string>& ids);

}  // namespace gradmesh
