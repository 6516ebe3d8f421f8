#include "formats/svg/write/write_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "form/blocks.h"
#include "form/rounding.h"
#include "form/written_patch.h"
#include "formats/svg/read/paint.h"
#include "formats/svg/read/read_group.h"
#include "formats/svg/read/read_mesh.h"
#include "formats/svg/read/written_gradient.h"
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

/// Returns the decimal step of coordinates in a gradient: rounding moves a control point by no more
/// than it may be off without anybody seeing it. Returns 0 where significant digits are shorter.
double step_in(const Affine& to_gradient, double coons_tolerance) {
  constexpr double share = 2;
  const glm::dmat2 from_gradient = to_gradient.inverse().linear;
  return decimal_step(share * coons_tolerance /
                      std::hypot(glm::length(from_gradient[0]), glm::length(from_gradient[1])));
}

}  // namespace

MeshObject write_mesh_gradient(SvgDocument& document, const MeshObject& object, const Mesh& mesh,
                               double coons_tolerance) {
  xmlNode* gradient = add_gradient(document, object);
  const Affine place = mesh_to_gradient(document, object);
  const double step = step_in(place, coons_tolerance);
  write_block_rows(gradient, mesh, find_grid(mesh).value(),
                   {.coons_tolerance = coons_tolerance,
                    .in_style = !document.styles().is_empty(),
                    .place = place,
                    .step = step,
                    .rounding = rounding_within(bounding_box(mesh, place)),
                    .is_relative = step > 0});
  for (const std::string& name : {original_name(object.role), fingerprint_name(object.role)})
    remove_attribute(object.node, name.c_str(), gradmesh_namespace);

  const char* property = object.role == PaintRole::fill ? "fill" : "stroke";
  const std::string fallback =
      fallback_color(document.styles().inherited(object.node, property).value_or(""));
  const std::string url = "url(#" + attribute(gradient, "id").value_or("") + ")";
  set_style(object.node, property, fallback.empty() ? url : url + " " + fallback);
  remove_if_unused(document, attribute(object.gradient, "id").value_or(""));
  return {object.node, object.id, object.role, gradient, object.kept};
}

void remember_original(SvgDocument& document, const MeshObject& written, double coons_tolerance,
                       const std::string& original) {
  const double step = step_in(mesh_to_gradient(document, written), coons_tolerance);
  if (step == 0) return;
  const auto set = [&](const std::string& name, const std::string& value) {
    set_attribute(written.node, name.c_str(), value, gradmesh_namespace, "gradmesh");
  };
  set(original_name(written.role), original);
  set(fingerprint_name(written.role), gradient_fingerprint(document, written.gradient, step));
}

MeshParts gradient_parts(const Mesh& mesh, double coons_tolerance, const Affine& to_gradient) {
  const Rectangle grid = find_grid(mesh).value();
  MeshParts parts{{}, grid_curves(grid.rows, grid.columns)};
  parts.smooth = mesh.is_smooth();
  const double step = step_in(to_gradient, coons_tolerance);
  for (const Halfedge top : grid.tops) {
    const Patch patch = as_written(mesh.patch(top), coons_tolerance);
    parts.patches.push_back(step > 0 ? rounded(patch, coons_tolerance, step, to_gradient) : patch);
  }
  return parts;
}

}  // namespace gradmesh
