#include "formats/svg/write/remove_blocks.h"

#include "formats/svg/read/objects.h"
#include "formats/svg/read/paint.h"
#include "formats/svg/read/read_group.h"
#include "formats/svg/xml/edit.h"
#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

/// Removes the blocks in a group or mask, and then their gradients.
std::string remove_paths(SvgDocument& document, xmlNode* parent) {
  std::string fallback;
  std::vector<std::string> gradients;
  for (xmlNode* path : child_elements(parent)) {
    if (!attribute(path, "face", gradmesh_namespace)) continue;
    if (const auto fill = document.styles().declared(path, "fill")) {
      if (const auto id = referenced_id(*fill)) gradients.push_back(*id);
      fallback = fallback_color(*fill);
    }
    remove_node(path);
  }
  for (const std::string& id : gradients) remove_if_unused(document, id);
  return fallback;
}

}  // namespace

std::string remove_blocks(SvgDocument& document, xmlNode* group) {
  if (xmlNode* mask = opacity_mask(document, group)) {
    remove_attribute(group, "mask");
    // A copy of the group may use it too.
    if (!is_used(document, attribute(mask, "id").value_or(""))) {
      remove_paths(document, mask);
      remove_node(mask);
    }
  }
  return remove_paths(document, group);
}

}  // namespace gradmesh
