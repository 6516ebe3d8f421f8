#include "formats/svg/gradient/paint_shape.h"

#include <optional>

#include "base/error.h"
#include "formats/svg/gradient/mesh_gradient.h"
#include "formats/svg/tree/objects.h"
#include "formats/svg/tree/paint.h"
#include "formats/svg/tree/unused.h"
#include "formats/svg/values/mesh_names.h"
#include "formats/svg/values/reference.h"
#include "formats/svg/values/shape.h"
#include "formats/svg/xml/node.h"
#include "formats/text/excerpt.h"

namespace gradmesh {
namespace {

/// Returns the shape with this id that a mesh gradient can fill.
xmlNode* shape_to_paint(const SvgTree& tree, const std::string& id) {
  xmlNode* const node = tree.find(id);
  if (!node) throw InputError("{0}: there is no object with the id {1}.", tree.name(), excerpt(id));
  const auto box = shape_box(node);
  if (!can_paint(node, PaintRole::fill) || !shape_outline(node) || !box || !(box->size().x > 0) ||
      !(box->size().y > 0) || to_document(node).determinant() == 0)
    throw InputError("{0}: {1} is no closed shape, such as a path, that a mesh could fill.",
                     tree.name(), excerpt(id));
  return node;
}

}  // namespace

Affine user_to_document(const SvgTree& tree, const std::string& id) {
  return to_document(shape_to_paint(tree, id));
}

void paint_shape(SvgTree& tree, const std::string& id, const Mesh& mesh, double coons_tolerance) {
  xmlNode* const shape = shape_to_paint(tree, id);
  const StyleSheet& styles = tree.styles();
  const auto painted_by = [&](const char* property) {
    return referenced_id(styles.declared(shape, property).value_or(""), tree.name());
  };
  const std::optional<std::string> fill = painted_by("fill"), stroke = painted_by("stroke");
  xmlNode* const gradient = add_child(tree.defs_around(shape), mesh_gradient_name);
  const std::string name = tree.give_id(gradient, id + "-mesh");
  set_attribute(gradient, "gradientUnits", "userSpaceOnUse");
  write_grid(tree, gradient, mesh, coons_tolerance, {});
  set_paint(styles, shape, "fill", paint_by(name));
  set_style(styles, shape, "fill-opacity", "1");
  set_style(styles, shape, "stroke", "none");
  for (const auto& old : {fill, stroke})
    if (old) remove_if_unused(tree, *old);
}

}  // namespace gradmesh
