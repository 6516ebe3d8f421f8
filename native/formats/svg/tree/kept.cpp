#include "formats/svg/tree/kept.h"

#include <algorithm>

#include "formats/svg/tree/own.h"
#include "formats/svg/tree/paint.h"
#include "formats/svg/xml/node.h"

namespace gradmesh {

void keep_hidden_copy(SvgTree& tree, const MeshObject& object) {
  if (std::ranges::any_of(elements_from(tree.root()), [&](const xmlNode* node) {
        return own_attribute(node, "kept-for") == object.id;
      }))
    return;
  xmlNode* node = whole_object(object.node);
  xmlNode* copy = add_copy(parent_element(node), node);
  xmlAddPrevSibling(node, copy);
  for (xmlNode* part : elements_from(copy)) remove_attribute(part, "id");
  const std::string id = object.id + "-original";
  if (tree.find(id))
    tree.give_id(copy, id);
  else
    tree.set_id(copy, id);
  // What a rule says of the object by its id.
  for (const char* paint : {"fill", "stroke"})
    if (const auto value = tree.styles().declared(node, paint);
        value && value != tree.styles().declared(copy, paint))
      set_style(tree.styles(), copy, paint, *value);
  set_style(tree.styles(), copy, "display", "none");
  set_own_attribute(copy, "kept-for", object.id);
}

void remove_hidden_originals(SvgTree& tree) {
  remove_elements(tree.root(),
                  [](const xmlNode* node) { return own_attribute(node, "kept-for").has_value(); });
}

}  // namespace gradmesh
