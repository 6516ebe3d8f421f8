#include "formats/svg/group/mixed_groups.h"

#include "formats/svg/tree/paint.h"
#include "formats/svg/xml/node.h"
#include "formats/text/number.h"

namespace gradmesh {
namespace {

xmlNode* add_group(SvgTree& tree, xmlNode* parent, const SvgGroup& group) {
  xmlNode* const node = add_child(parent, "g");
  const auto style = [&](const char* property, const std::string& value) {
    set_style(tree.styles(), node, property, value);
  };
  if (group.opacity != 1) style("opacity", format_number(group.opacity));
  if (group.blend_mode != "normal") style("mix-blend-mode", group.blend_mode);
  if (group.is_isolated) style("isolation", "isolate");
  return node;
}

}  // namespace

xmlNode* MixedGroups::within(SvgTree& tree, xmlNode* layer,
                             const std::vector<std::shared_ptr<const SvgGroup>>& groups) {
  xmlNode* here = layer;
  for (const auto& group : groups) {
    xmlNode*& made = made_[group];
    if (!made || made != xmlLastElementChild(here)) made = add_group(tree, here, *group);
    here = made;
  }
  return here;
}

}  // namespace gradmesh
