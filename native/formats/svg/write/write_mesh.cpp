#include "formats/svg/write/write_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "form/blocks.h"
#include "form/handles.h"
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
/// than it may be off without anybody seeing it. Returns 0 where that has so many decimals that
/// significant digits are shorter.
double step_in(const Affine& to_gradient, double coons_tolerance) {
  constexpr double share = 2, least = 1e-9;
  const glm::dmat2 from_gradient = to_gradient.inverse().linear;
  const double step = share * coons_tolerance /
                      std::hypot(glm::length(from_gradient[0]), glm::length(from_gradient[1]));
  return step < least ? 0 : decimal_step(step);
}

/// Returns the patch with its coordinates in the gradient rounded as they are written.
Patch rounded(const Patch& patch, double coons_tolerance, const Affine& to_gradient) {
  const double step = step_in(to_gradient, coons_tolerance);
  if (step == 0) return patch;
  const auto round = [&](glm::dvec2 p) {
    return glm::dvec2(round_to_step(p.x, step), round_to_step(p.y, step));
  };
  std::array<Cubic<Value>, 4> sides;
  for (int k = 0; k < 4; ++k) {
    const Cubic<Value> side = patch.side(k);
    const glm::dvec2 from = round(to_gradient.point(side.p0.position));
    const glm::dvec2 to = round(to_gradient.point(side.p1.position));
    Cubic<Value>& written = sides[std::size_t(k)] = side;
    written.p0.position = from;
    written.p1.position = to;
    written.m0.position = written.m1.position = to - from;
    if (is_straight(side, straight_tolerance(coons_tolerance))) continue;
    written.m0.position = 3.0 * (round(to_gradient.point(side.bezier1().position)) - from);
    written.m1.position = 3.0 * (to - round(to_gradient.point(side.bezier2().position)));
  }
  Patch result = patch_from_sides(sides, {});
  make_coons(result);
  if (needs_tensor(patch, coons_tolerance)) {
    Patch placed = patch;
    transform(placed, to_gradient);
    const BezierNet wanted = bezier_net(placed);
    BezierNet net = bezier_net(result);
    for (const int i : {1, 2})
      for (const int j : {1, 2}) {
        const int corner_i = i == 1 ? 0 : 3, corner_j = j == 1 ? 0 : 3;
        net[i][j].position = net[corner_i][corner_j].position +
                             round(wanted[i][j].position - wanted[corner_i][corner_j].position);
      }
    result = patch_from_bezier(net);
  }
  transform(result, to_gradient.inverse());
  make_color_bilinear(result);
  return result;
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
                    .rounding = rounding_within(bounding_box(mesh, place)),
                    .step = step});
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
  for (const Halfedge top : grid.tops)
    parts.patches.push_back(
        rounded(as_written(patch_from(mesh, top), coons_tolerance), coons_tolerance, to_gradient));
  return parts;
}

}  // namespace gradmesh
