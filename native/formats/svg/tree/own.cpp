#include "formats/svg/tree/own.h"

#include "formats/svg/xml/node.h"

namespace gradmesh {

std::optional<std::string> own_attribute(const xmlNode* node, const char* name) {
  return attribute(node, name, gradmesh_namespace);
}

void set_own_attribute(xmlNode* node, const char* name, const std::string& value) {
  if (value.empty())
    remove_attribute(node, name, gradmesh_namespace);
  else
    set_attribute(node, name, value, gradmesh_namespace, "gradmesh");
}

bool is_mesh_group(const xmlNode* node) {
  return svg_name(node) == "g" && own_attribute(node, "version");
}

bool is_block(const xmlNode* node) { return own_attribute(node, "face").has_value(); }

bool is_opacity_mask(const xmlNode* node) {
  return svg_name(node) == "mask" && own_attribute(node, "opacity");
}

std::vector<xmlNode*> with_outer(xmlNode* node) {
  std::vector<xmlNode*> nodes;
  do nodes.push_back(node);
  while ((node = parent_element(node)) && own_attribute(node, "outer"));
  return nodes;
}

}  // namespace gradmesh
