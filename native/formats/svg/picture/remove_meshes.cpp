#include "formats/svg/picture/remove_meshes.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "formats/svg/gradient/mesh_gradient.h"
#include "formats/svg/tree/objects.h"
#include "formats/svg/tree/own.h"
#include "formats/svg/tree/paint.h"
#include "formats/svg/tree/unused.h"
#include "formats/svg/values/mesh_names.h"
#include "formats/svg/values/reference.h"
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

void remove_unused_gradients(SvgTree& tree) {
  replace_paints(tree, unused_mesh_gradients(tree, mesh_objects(tree)));
  // Those that give others their rows become unused after these.
  const auto next_unused = [&]() -> xmlNode* {
    for (xmlNode* node : elements_from(tree.root()))
      if (is_mesh_gradient(node) && !is_used(tree, attribute(node, "id").value_or(""))) return node;
    return nullptr;
  };
  while (xmlNode* gradient = next_unused()) remove_named(tree, gradient);
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
