#include "formats/svg/write/keep_original.h"

#include "formats/svg/read/paint.h"
#include "formats/svg/read/read_group.h"
#include "formats/svg/xml/edit.h"
#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

bool is_kept(const xmlNode* node, const std::string& id) {
  if (attribute(node, "kept-for", gradmesh_namespace) == id) return true;
  for (const xmlNode* child : child_elements(node))
    if (is_kept(child, id)) return true;
  return false;
}

void remove_ids(xmlNode* node) {
  remove_attribute(node, "id");
  for (xmlNode* child : child_elements(node)) remove_ids(child);
}

}  // namespace

void keep_hidden_copy(SvgDocument& document, const MeshObject& object) {
  if (is_kept(document.root(), object.id)) return;
  xmlNode* node = whole_object(object.node);
  xmlNode* copy = add_copy(parent_element(node), node);
  xmlAddPrevSibling(node, copy);
  remove_ids(copy);
  const std::string id = object.id + "-original";
  if (document.find(id))
    document.give_id(copy, id);
  else
    document.set_id(copy, id);
  // What a rule says of the object by its id.
  for (const char* paint : {"fill", "stroke"})
    if (const auto value = document.styles().declared(node, paint);
        value && value != document.styles().declared(copy, paint))
      set_style(copy, paint, *value);
  set_style(copy, "display", "none");
  set_attribute(copy, "kept-for", object.id, gradmesh_namespace, "gradmesh");
}

}  // namespace gradmesh
