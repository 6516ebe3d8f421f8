#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "formats/pdf/grid/mesh_forms.h"
#include "formats/pdf/page/page_path.h"
#include "formats/pdf/page/page_stroke.h"
#include "formats/svg/group/new_svg.h"
#include "mesh/mesh.h"

namespace gradmesh {

/// Pixels of SVG in a point of PDF.
inline constexpr double pixels_per_point = 96.0 / 72;

/// A mesh that was chosen to stand for the patches of a page.
struct ChosenForm {
  MeshForm::Kind kind = MeshForm::Kind::page;
  /// In pixels of SVG.
  Mesh mesh;
  /// FLIP against the page's own patches, 700 pixels along the longer side.
  double difference = 0;
  /// The handles of the page's own patches, all joined.
  int page_handles = 0;
};

/// Returns the first of the forms that looks as the patches of the page do, or else the last one.
/// Throws InputError where the patches have no size.
ChosenForm choose_form(const std::vector<PagePatch>& patches, std::vector<MeshForm> forms);

/// Returns the shapes through which a mesh of a page is seen, the innermost first: clip paths
/// that hide some of it, or else its own outline alone; in front of them the path of the stroke, if
/// it paints one. Empty if they hide all of it.
std::vector<SvgShape> shapes_of(const Mesh& mesh, const Clips& clips, const PageStroke* stroke);

/// Returns the same stroke in pixels.
SvgStroke svg_stroke(const LineStyle& line);

}  // namespace gradmesh
