#include "formats/svg/group/new_svg.h"

#include <algorithm>

#include "formats/svg/tree/paint.h"
#include "formats/svg/values/mesh_names.h"
#include "formats/svg/values/reference.h"
#include "formats/svg/xml/node.h"
#include "formats/text/number.h"

namespace gradmesh {
namespace {

constexpr const char* sodipodi_namespace = "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd";
/// Pixels between pages that lie beside one another.
constexpr double gap = 20;

/// Returns a document without objects: defs and, where there are several pages, what Inkscape knows
/// them by.
std::string empty_document(const std::vector<SvgPage>& pages) {
  const std::string width = format_number(pages.front().width),
                    height = format_number(pages.front().height);
  std::string text = "<svg xmlns=\"" + std::string(svg_namespace) + "\" xmlns:inkscape=\"" +
                     std::string(inkscape_namespace) + "\"";
  if (pages.size() > 1) text.append(" xmlns:sodipodi=\"").append(sodipodi_namespace).append("\"");
  text += " width=\"" + width + "\" height=\"" + height + "\" viewBox=\"0 0 " + width + " " +
          height + "\">\n";
  if (pages.size() > 1) {
    text += "<sodipodi:namedview>\n";
    double x = 0;
    for (const SvgPage& page : pages) {
      text += "<inkscape:page x=\"" + format_number(x) + "\" y=\"0\" width=\"" +
              format_number(page.width) + "\" height=\"" + format_number(page.height) + "\"/>\n";
      x += page.width + gap;
    }
    text += "</sodipodi:namedview>\n";
  }
  return text + "<defs/>\n</svg>\n";
}

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

}  // namespace

NewSvg::NewSvg(const std::vector<SvgPage>& pages)
    : tree_(SvgTree::parse(empty_document(pages), "new document")), pages_(pages.size()) {
  if (pages_ == 1) return;
  double x = 0;
  for (const SvgPage& page : pages) {
    xmlNode* const layer = add_child(tree_.root(), "g");
    tree_.give_id(layer, "layer");
    set_attribute(layer, "groupmode", "layer", inkscape_namespace, "inkscape");
    set_attribute(layer, "label", page.name, inkscape_namespace, "inkscape");
    if (x > 0) set_attribute(layer, "transform", "translate(" + format_number(x) + ",0)");
    x += page.width + gap;
  }
}

xmlNode* NewSvg::layer(std::size_t page) const {
  return pages_ == 1 ? tree_.root() : child_elements(tree_.root(), "g").at(page);
}

xmlNode* NewSvg::clipped(xmlNode* layer, const NewMesh& mesh) {
  for (const SvgShape& shape : mesh.clips) {
    xmlNode* const clip = add_child(tree_.defs(), "clipPath");
    const std::string id = tree_.give_id(clip, mesh.id + "-clip");
    set_attribute(clip, "clipPathUnits", "userSpaceOnUse");
    add_path(clip, shape, "clip-rule");
    layer = add_child(layer, "g");
    set_attribute(layer, "clip-path", paint_by(id));
  }
  return layer;
}

void NewSvg::add(std::size_t page, const NewMesh& mesh) {
  const auto& [id, shape, clips, written, stroke, blend_mode] = mesh;
  MeshObject object{.node = add_path(clipped(layer(page), mesh), shape, "fill-rule"),
                    .id = id,
                    .role = stroke ? PaintRole::stroke : PaintRole::fill};
  tree_.set_id(object.node, id);
  const std::string gradient = add_gradient(tree_, written.mesh, written.form.blocks.front(),
                                            {.precision = written.form.precision}, id + "-mesh");
  object.gradient = tree_.find(gradient);
  if (written.mesh.is_smooth()) set_attribute(object.gradient, "type", "bicubic");
  set_attribute(object.node, "style", style_of(stroke, gradient));
  if (is_rectangle(written.mesh, written.form.blocks))
    set_attribute(object.node, "label", written.label, inkscape_namespace, "inkscape");
  else
    write_group(tree_, object, written);
  if (blend_mode == "normal") return;
  // What a group clips is mixed with nothing below the group, so this is for the group to do.
  xmlNode* outermost = tree_.find(id);
  while (parent_element(outermost) != layer(page)) outermost = parent_element(outermost);
  set_style(tree_.styles(), outermost, "mix-blend-mode", blend_mode);
}

}  // namespace gradmesh
