#pragma once

#include <string>
#include <vector>

#include "formats/pdf/objects/page_path.h"
#include "formats/pdf/page/page_stroke.h"
#include "formats/svg/group/new_svg.h"
#include "mesh/mesh.h"

namespace gradmesh {

/// Pixels of SVG in a point of PDF.
inline constexpr double pixels_per_point = 96.0 / 72;

/// Returns the path in pixels of SVG.
std::string path_data(const PagePath& path);

/// Returns the shapes through which a mesh of a page is seen, the innermost first: clip paths
/// that hide some of it, or else what is around it alone; in front of them the path of the stroke,
/// if it paints one, in the coordinates of its pen, as those of the mesh are. Empty if they hide
/// all of it.
std::vector<SvgShape> shapes_of(const Mesh& mesh, const Clips& clips, const PageStroke* stroke);

/// Returns the same stroke in pixels.
SvgStroke svg_stroke(const LineStyle& line);

}  // namespace gradmesh
