#include "formats/svg/group/new_object.h"

#include "formats/svg/tree/paint.h"
#include "formats/svg/values/mesh_names.h"
#include "formats/svg/values/reference.h"
#include "formats/svg/values/transform.h"
#include "formats/svg/xml/node.h"
#include "formats/text/number.h"

namespace gradmesh {
namespace {

/// Returns true if the mesh is one block whose sides are the boundary of the mesh; the block of a
/// ring is joined to itself.
bool is_rectangle(const Mesh& mesh, const std::vector<Rectangle>& blocks) {
  if (blocks.size() != 1) return false;
  const Rectangle& block = blocks.front();
  int on_boundary = 0;
  for (const Halfedge h : mesh.halfedges())
    on_boundary += mesh.is_leaf(h) && !mesh.other_side(h).valid();
  return on_boundary == 2 * (block.rows + block.columns);
}

xmlNode* add_path(xmlNode* parent, const SvgShape& shape, const char* rule) {
  xmlNode* const path = add_child(parent, "path");
  set_attribute(path, "d", shape.path);
  if (shape.rule == FillRule::evenodd) set_attribute(path, rule, "evenodd");
  return path;
}

/// Returns the style of a shape that is painted by what has this id.
std::string style_of(const std::optional<SvgStroke>& stroke, const std::string& id) {
  if (!stroke) return "fill:" + paint_by(id) + ";stroke:none";
  std::string style = "fill:none;stroke:" + paint_by(id) +
                      ";stroke-width:" + format_number(stroke->width) +
                      ";stroke-linecap:" + stroke->cap + ";stroke-linejoin:" + stroke->join +
                      ";stroke-miterlimit:" + format_number(stroke->miter_limit);
  if (stroke->dashes.empty()) return style;
  style += ";stroke-dasharray:";
  for (std::size_t n = 0; n < stroke->dashes.size(); ++n)
    style.append(n > 0 ? "," : "").append(format_number(stroke->dashes[n]));
  return style + ";stroke-dashoffset:" + format_number(stroke->dash_offset);
}

/// Adds the groups that clip what is in them. Returns the innermost, or the group itself.
xmlNode* clipped(SvgTree& tree, xmlNode* group, const NewMesh& mesh) {
  for (const SvgShape& shape : mesh.clips) {
    xmlNode* const clip = add_child(tree.defs(), "clipPath");
    const std::string id = tree.give_id(clip, mesh.id + "-clip");
    set_attribute(clip, "clipPathUnits", "userSpaceOnUse");
    add_path(clip, shape, "clip-rule");
    group = add_child(group, "g");
    set_attribute(group, "clip-path", paint_by(id));
  }
  return group;
}

}  // namespace

xmlNode* add_object(SvgTree& tree, xmlNode* group, const NewMesh& mesh) {
  const auto& [id, shape, clips, written, stroke, blend_mode, to_page, groups] = mesh;
  MeshObject object{.node = add_path(clipped(tree, group, mesh), shape, "fill-rule"),
                    .id = id,
                    .role = stroke ? PaintRole::stroke : PaintRole::fill};
  tree.set_id(object.node, id);
  if (!(to_page == Affine())) set_attribute(object.node, "transform", transform_text(to_page));
  const std::string gradient = add_gradient(tree, written.mesh, written.form.blocks.front(),
                                            {.precision = written.form.precision}, id + "-mesh");
  object.gradient = tree.find(gradient);
  if (written.mesh.is_smooth()) set_attribute(object.gradient, "type", "bicubic");
  set_attribute(object.node, "style", style_of(stroke, gradient));
  if (is_rectangle(written.mesh, written.form.blocks))
    set_attribute(object.node, "label", written.label, inkscape_namespace, "inkscape");
  else
    write_group(tree, object, written);
  xmlNode* outermost = tree.find(id);
  while (parent_element(outermost) != group) outermost = parent_element(outermost);
  // What a group clips is mixed with nothing below the group, so this is for the group to do.
  if (blend_mode != "normal") set_style(tree.styles(), outermost, "mix-blend-mode", blend_mode);
  return outermost;
}

}  // namespace gradmesh
