#include "formats/svg/picture/remove_meshes.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "formats/svg/gradient/mesh_gradient.h"
#include "formats/svg/tree/objects.h"
#include "formats/svg/tree/own.h"
#include "formats/svg/tree/paint.h"
#include "formats/svg/values/mesh_names.h"
#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

/// Gives what names one of these gradients the colour that stands in for it.
void replace_paints(SvgTree& tree, const std::vector<const xmlNode*>& gradients) {
  for (xmlNode* node : elements_from(tree.root()))
    for (const char* property : {"fill", "stroke"}) {
      const auto paint = tree.styles().declared(node, property);
      const xmlNode* gradient = referenced_mesh(tree, paint);
      if (!gradient || std::ranges::find(gradients, gradient) == gradients.end()) continue;
      const std::string fallback = fallback_color(*paint);
      set_style(tree.styles(), node, property, fallback.empty() ? "none" : fallback);
    }
}

/// Returns rules in which the paints that name this id are replaced by their colours.
std::string without_paint(std::string css, const std::string& id) {
  for (std::size_t at = 0; (at = css.find("url(", at)) != css.npos;) {
    const std::size_t end = std::min(css.find_first_of(";}", at), css.size());
    const std::string_view paint = std::string_view(css).substr(at, end - at);
    if (referenced_id(paint) != id) {
      ++at;
      continue;
    }
    const std::string fallback = fallback_color(paint);
    css.replace(at, end - at,
                fallback.empty() || fallback.front() == '!' ? "none" + fallback : fallback);
  }
  return css;
}

void replace_paints_in_rules(SvgTree& tree, const std::vector<const xmlNode*>& gradients) {
  for (const xmlNode* node : elements_from(tree.root())) {
    if (svg_name(node) != "style") continue;
    for (xmlNode* text = node->children; text; text = text->next) {
      if (text->type != XML_TEXT_NODE && text->type != XML_CDATA_SECTION_NODE) continue;
      const std::string css(view(text->content));
      std::string changed = css;
      for (const xmlNode* gradient : gradients)
        changed = without_paint(changed, attribute(gradient, "id").value_or(""));
      if (changed != css)
        xmlNodeSetContent(text, reinterpret_cast<const xmlChar*>(changed.c_str()));
    }
  }
}

void remove_unused_gradients(SvgTree& tree) {
  const auto unused = unused_mesh_gradients(tree, mesh_objects(tree));
  replace_paints(tree, unused);
  replace_paints_in_rules(tree, unused);
  // Those that give others their rows become unused after these.
  const auto next_unused = [&]() -> xmlNode* {
    for (xmlNode* node : elements_from(tree.root()))
      if (is_mesh_gradient(node) && !is_used(tree, attribute(node, "id").value_or(""))) return node;
    return nullptr;
  };
  while (xmlNode* gradient = next_unused()) remove_node(gradient);
}

bool is_polyfill(const xmlNode* node) {
  return svg_name(node) == "script" &&
         attribute(node, "id").value_or("").starts_with("mesh_polyfill");
}

bool is_ours(const xmlNs* space) { return space && view(space->href) == gradmesh_namespace; }

/// Takes our attributes away, and the declarations of our namespace if no element is in it.
void remove_own_namespace(SvgTree& tree) {
  const auto all = elements_from(tree.root());
  for (const xmlNode* node : all)
    for (xmlAttr* a : attributes(node))
      if (is_ours(a->ns)) xmlRemoveProp(a);
  if (std::ranges::any_of(all, [](const xmlNode* node) { return is_ours(node->ns); })) return;
  for (xmlNode* node : all)
    for (xmlNs** at = &node->nsDef; *at;) {
      if (!is_ours(*at)) {
        at = &(*at)->next;
        continue;
      }
      xmlNs* gone = *at;
      *at = gone->next;
      xmlFreeNs(gone);
    }
}

}  // namespace

void remove_meshes(SvgTree& tree) {
  remove_elements(tree.root(), is_polyfill);
  remove_unused_gradients(tree);
  remove_own_namespace(tree);
}

}  // namespace gradmesh
