#include "formats/svg/group/written_label.h"

#include "formats/svg/tree/own.h"
#include "formats/svg/xml/node.h"
#include "formats/text/excerpt.h"

namespace gradmesh {

bool take_written_label(const MeshObject& object,
                        const std::function<bool(const std::string&)>& is_ours) {
  const auto written = own_attribute(object.node, "label");
  bool was_there = false;
  for (xmlNode* node : with_outer(object.node)) {
    const auto shown = attribute(node, "label", inkscape_namespace);
    if (!shown || (shown != written && !is_ours(*shown))) continue;
    remove_attribute(node, "label", inkscape_namespace);
    was_there = true;
  }
  set_own_attribute(object.node, "label", "");
  return was_there;
}

void give_written_label(xmlNode* node, const std::string& label) {
  set_own_attribute(node, "label", label);
  // The group around it, where there is one, is what the person sees first.
  for (xmlNode* outer : with_outer(node))
    if (!attribute(outer, "label", inkscape_namespace))
      set_attribute(outer, "label", label, inkscape_namespace, "inkscape");
}

Message called(const xmlNode* node) {
  const auto label = attribute(node, "label", inkscape_namespace);
  if (label && !label->empty() && label != own_attribute(node, "label"))
    return Message("{0}", excerpt(*label));
  if (svg_name(node) == "image") return Message("the picture");
  return Message("{0}", excerpt(attribute(node, "id").value_or("")));
}

}  // namespace gradmesh
