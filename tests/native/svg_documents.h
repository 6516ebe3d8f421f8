#pragma once

#include <string>

#include "complaint.h"
#include "formats/svg/tree/objects.h"
#include "formats/svg/xml/node.h"

/// What tests of SVG documents share.
namespace gradmesh::test {

/// The name of documents in messages.
inline constexpr const char* drawing_name = "drawing.svg";

inline std::string svg_text(const std::string& content) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
         "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" width=\"400\" "
         "height=\"400\">" +
         content + "</svg>";
}

inline SvgTree svg_tree(const std::string& content) {
  return SvgTree::parse(svg_text(content), drawing_name);
}

/// Returns the elements of this SVG name below `root`, in document order.
inline std::vector<xmlNode*> elements_called(const xmlNode* root, std::string_view name) {
  std::vector<xmlNode*> found = elements_from(root);
  std::erase_if(found, [&](const xmlNode* node) { return svg_name(node) != name; });
  return found;
}

/// Returns an attribute's value as tests compare it: "(none)" where it is absent.
inline std::string text_of_attribute(const xmlNode* node, const char* name) {
  return attribute(node, name).value_or("(none)");
}

}  // namespace gradmesh::test
