#include "formats/svg/write/write_new.h"

#include "formats/svg/write/write_gradient.h"
#include "formats/svg/xml/edit.h"
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

std::string empty_page(const SvgPage& page) {
  const std::string width = format_number(page.width), height = format_number(page.height);
  return "<svg xmlns=\"" + std::string(svg_namespace) + "\" xmlns:inkscape=\"" +
         std::string(inkscape_namespace) + "\" width=\"" + width + "\" height=\"" + height +
         "\" viewBox=\"0 0 " + width + " " + height + "\">\n<defs/>\n<path/>\n</svg>\n";
}

}  // namespace

SvgDocument new_svg(const SvgPage& page, const std::string& outline, const WrittenMesh& written) {
  SvgDocument document = SvgDocument::parse(empty_page(page), "new document");
  xmlNode* defs = document.defs();
  MeshObject object{.node = child_elements(document.root(), "path").front(), .id = "mesh"};
  document.set_id(object.node, object.id);
  const std::string gradient = write_block_gradient(
      document, defs, written.mesh, written.form.blocks.front(),
      {.coons_tolerance = written.form.coons_tolerance, .step = written.form.step},
      "mesh-gradient");
  object.gradient = document.find(gradient);
  set_attribute(object.node, "d", outline);
  set_attribute(object.node, "style", "fill:url(#" + gradient + ");stroke:none");
  if (is_rectangle(written.mesh, written.form.blocks))
    set_attribute(object.node, "label", written.label, inkscape_namespace, "inkscape");
  else
    write_mesh(document, object, written);
  return document;
}

}  // namespace gradmesh
