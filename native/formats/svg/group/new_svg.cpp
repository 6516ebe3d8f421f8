#include "formats/svg/group/new_svg.h"

#include "formats/svg/xml/node.h"
#include "formats/text/number.h"

namespace gradmesh {
namespace {

constexpr const char* sodipodi_namespace = "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd";

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
      x += page.width + page_gap;
    }
    text += "</sodipodi:namedview>\n";
  }
  return text + "<defs/>\n</svg>\n";
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
    x += page.width + page_gap;
  }
}

xmlNode* NewSvg::layer(std::size_t page) const {
  return pages_ == 1 ? tree_.root() : child_elements(tree_.root(), "g").at(page);
}

}  // namespace gradmesh
