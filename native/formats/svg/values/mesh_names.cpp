#include "formats/svg/values/mesh_names.h"

#include <algorithm>
#include <string_view>

#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

std::vector<xmlNode*> children_called(const xmlNode* node, std::string_view name,
                                      std::string_view earlier) {
  std::vector<xmlNode*> children = child_elements(node);
  std::erase_if(children, [&](const xmlNode* child) {
    return svg_name(child) != name && svg_name(child) != earlier;
  });
  return children;
}

}  // namespace

bool is_mesh_gradient(const xmlNode* node) {
  const std::string_view name = svg_name(node);
  return name == mesh_gradient_name || name == "meshGradient" || name == "mesh";
}

bool is_gradient(const xmlNode* node) {
  const std::string_view name = svg_name(node);
  return is_mesh_gradient(node) || name == "linearGradient" || name == "radialGradient";
}

std::vector<xmlNode*> mesh_rows(const xmlNode* gradient) {
  return children_called(gradient, mesh_row_name, "meshRow");
}

std::vector<xmlNode*> mesh_patches(const xmlNode* row) {
  return children_called(row, mesh_patch_name, "meshPatch");
}

}  // namespace gradmesh
