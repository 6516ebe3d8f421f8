#include "formats/svg/write/write_mesh.h"

#include <algorithm>

#include "form/blocks.h"
#include "form/written_patch.h"
#include "formats/svg/read/paint.h"
#include "formats/svg/read/read_mesh.h"
#include "formats/svg/values/mesh_names.h"
#include "formats/svg/write/write_gradient.h"
#include "formats/svg/xml/edit.h"
#include "formats/svg/xml/node.h"
#include "mesh/boundary.h"
#include "mesh/rectangle.h"

namespace gradmesh {
namespace {

/// Adds a gradient beside the old one, equal to it but for its rows, which the old one may have by
/// href.
xmlNode* add_gradient(SvgDocument& document, const MeshObject& object) {
  xmlNode* old = object.gradient;
  xmlNode* gradient = add_copy(parent_element(old), old);
  while (gradient->children) remove_node(gradient->children);
  set_name(gradient, mesh_gradient_name);
  xmlAddNextSibling(old, gradient);
  document.give_id(gradient, object.id + "-mesh");
  remove_attribute(gradient, "href");
  remove_attribute(gradient, "href", xlink_namespace);
  set_attribute(gradient, "gradientUnits",
                in_bounding_box(document, old) ? "objectBoundingBox" : "userSpaceOnUse");
  return gradient;
}

}  // namespace

void write_mesh_gradient(SvgDocument& document, const MeshObject& object, const Mesh& mesh,
                         double coons_tolerance) {
  xmlNode* gradient = add_gradient(document, object);
  const Affine place = mesh_to_gradient(document, object);
  write_block_rows(gradient, mesh, find_grid(mesh).value(),
                   {.coons_tolerance = coons_tolerance,
                    .place = place,
                    .rounding = rounding_within(bounding_box(mesh, place))});

  const char* property = object.role == PaintRole::fill ? "fill" : "stroke";
  const std::string fallback =
      fallback_color(document.styles().inherited(object.node, property).value_or(""));
  const std::string url = "url(#" + attribute(gradient, "id").value_or("") + ")";
  set_style(object.node, property, fallback.empty() ? url : url + " " + fallback);
  remove_if_unused(document, attribute(object.gradient, "id").value_or(""));
}

MeshParts gradient_parts(const Mesh& mesh, double coons_tolerance) {
  const Rectangle grid = find_grid(mesh).value();
  MeshParts parts{{}, grid_curves(grid.rows, grid.columns)};
  parts.smooth = mesh.is_smooth();
  for (const Halfedge top : grid.tops)
    parts.patches.push_back(as_written(patch_from(mesh, top), coons_tolerance));
  return parts;
}

}  // namespace gradmesh
