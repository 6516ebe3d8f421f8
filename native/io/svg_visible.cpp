#include "io/svg_visible.h"

#include "io/svg_group.h"
#include "io/svg_shape.h"
#include "io/xml_node.h"

namespace gradmesh {
namespace {

/// The shape that clips a group of blocks, which the group or one around it for the same object
/// names; null where there is none.
const xmlNode* clipping_shape(const SvgDocument& document, const xmlNode* group) {
  for (const xmlNode* node = group; node; node = parent_element(node)) {
    if (node != group && !attribute(node, "outer", gradmesh_namespace)) break;
    const auto reference = attribute(node, "clip-path");
    const auto id = reference ? referenced_id(*reference) : std::nullopt;
    const xmlNode* clip = id ? document.find(*id) : nullptr;
    if (!clip) continue;
    const auto shapes = child_elements(clip);
    return shapes.size() == 1 ? shapes.front() : nullptr;
  }
  return nullptr;
}

}  // namespace

std::optional<VisibleArea> visible_area(const SvgDocument& document, const MeshObject& object) {
  if (object.role == PaintRole::stroke) return std::nullopt;
  const bool group = is_mesh_group(object.node);
  const xmlNode* shape = group ? clipping_shape(document, object.node) : object.node;
  // A clip that a person has moved shows another part.
  if (!shape || (group && attribute(shape, "transform"))) return std::nullopt;
  std::optional<Outline> outline = shape_outline(shape);
  if (!outline) return std::nullopt;
  const auto rule = document.styles().inherited(shape, group ? "clip-rule" : "fill-rule");
  return VisibleArea{*std::move(outline),
                     rule == "evenodd" ? FillRule::evenodd : FillRule::nonzero};
}

}  // namespace gradmesh
