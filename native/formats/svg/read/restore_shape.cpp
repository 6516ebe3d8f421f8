#include "formats/svg/read/restore_shape.h"

#include <string>
#include <vector>

#include "formats/svg/read/paint.h"
#include "formats/svg/read/read_group.h"
#include "formats/svg/values/mesh_names.h"
#include "formats/svg/xml/edit.h"
#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

bool is_outer(const xmlNode* node) {
  return node && attribute(node, "outer", gradmesh_namespace).has_value();
}

xmlNode* outermost_group(xmlNode* group) {
  while (is_outer(parent_element(group))) group = parent_element(group);
  return group;
}

int count_mesh_groups(const xmlNode* node) {
  int count = is_mesh_group(node);
  for (const xmlNode* child : child_elements(node)) count += count_mesh_groups(child);
  return count;
}

class ShapeRestorer {
 public:
  ShapeRestorer(SvgDocument& document, const MeshObject& object)
      : document_(document),
        group_(object.node),
        outermost_(outermost_group(object.node)),
        role_(object.role),
        id_(object_id(object.node)) {}

  void check() {
    if (count_mesh_groups(outermost_) > 1)
      fail(group_, Message("the fill and the stroke of its object are both made of blocks"));
    find_holder();
  }

  MeshObject run() {
    check();
    xmlNode* shape = take_shape();
    xmlAddPrevSibling(outermost_, shape);
    const std::string fallback = collect_gradients();
    give_group_attributes(shape);

    xmlNode* gradient = add_child(document_.defs(), mesh_gradient_name);
    set_attribute(gradient, "gradientUnits", "userSpaceOnUse");
    const std::string name = document_.give_id(gradient, id_ + "-mesh");
    const std::string paint = "url(#" + name + ")" + (fallback.empty() ? "" : " " + fallback);
    set_style(shape, is_stroke() ? "stroke" : "fill", paint);

    remove_node(outermost_);
    for (const std::string& unused : unused_) remove_if_unused(document_, unused);
    document_.set_id(shape, id_);
    return {shape, id_, role_, gradient};
  }

 private:
  bool is_stroke() const { return role_ == PaintRole::stroke; }
  const char* holding_attribute() const { return is_stroke() ? "mask" : "clip-path"; }

  /// Returns the element that an attribute names; null if there is none.
  xmlNode* named(const xmlNode* node, const char* name) const {
    const auto reference = attribute(node, name);
    const auto id = reference ? referenced_id(*reference) : std::nullopt;
    return id ? document_.find(*id) : nullptr;
  }

  /// Finds the innermost group that the object's shape clips or masks, which an opacity mask does
  /// not. Throws InputError if there is none.
  void find_holder() {
    for (xmlNode* node = group_; !holding_; node = parent_element(node)) {
      xmlNode* found = named(node, holding_attribute());
      if (found && !attribute(found, "opacity", gradmesh_namespace)) {
        holder_ = node;
        holding_ = found;
      }
      if (node == outermost_) break;
    }
    const auto held = holding_ ? child_elements(holding_) : std::vector<xmlNode*>();
    if (held.size() != 1 || !can_paint(held.front(), role_))
      fail(group_, Message("its {0} no longer holds its shape", holding_attribute()));
    unused_.push_back(attribute(holding_, "id").value_or(""));
    if (const xmlNode* mask = opacity_mask(document_, group_))
      unused_.push_back(attribute(mask, "id").value_or(""));
  }

  /// Takes the shape out of the document and returns it: the object that paints beside the blocks
  /// if there is one, otherwise the content of the clip path or mask.
  xmlNode* take_shape() {
    xmlNode* shape = nullptr;
    for (xmlNode* child : child_elements(outermost_)) {
      const bool is_block = attribute(child, "face", gradmesh_namespace).has_value();
      if (!is_block && can_paint(child, role_)) shape = child;
    }
    if (!shape) {
      shape = child_elements(holding_).front();
      const std::string rule = take_style(shape, "clip-rule");
      if (!rule.empty()) set_style(shape, "fill-rule", rule);
    }
    xmlUnlinkNode(shape);
    return shape;
  }

  void give_group_attributes(xmlNode* shape) {
    // Inside another group its opacity is that of the paint alone.
    if (group_ != outermost_) {
      const std::string opacity = take_style(group_, "opacity");
      if (!opacity.empty())
        set_style(shape, is_stroke() ? "stroke-opacity" : "fill-opacity", opacity);
    }
    if (holder_ == outermost_) remove_attribute(outermost_, holding_attribute());
    if (group_ == outermost_ && opacity_mask(document_, group_)) remove_attribute(group_, "mask");
    // A label that the person has given stays.
    if (attribute(outermost_, "label", inkscape_namespace) ==
        attribute(group_, "label", gradmesh_namespace))
      remove_attribute(outermost_, "label", inkscape_namespace);
    return_group_attributes(outermost_, shape);
  }

  /// Adds the gradients of the blocks to `unused_`. Returns the colour for programs that know no
  /// meshes.
  std::string collect_gradients() {
    std::string fallback;
    for (const xmlNode* path : child_elements(group_)) {
      if (!attribute(path, "face", gradmesh_namespace)) continue;
      const auto fill = document_.styles().declared(path, "fill");
      const auto id = fill ? referenced_id(*fill) : std::nullopt;
      if (id) unused_.push_back(*id);
      if (fill) fallback = fallback_color(*fill);
    }
    if (const xmlNode* mask = opacity_mask(document_, group_))
      for (const xmlNode* path : child_elements(mask))
        if (const auto fill = document_.styles().declared(path, "fill"))
          if (const auto id = referenced_id(*fill)) unused_.push_back(*id);
    return fallback;
  }

  SvgDocument& document_;
  xmlNode* group_;
  xmlNode* outermost_;
  const PaintRole role_;
  const std::string id_;
  /// The group that the shape clips or masks, and the clip path or mask.
  xmlNode* holder_ = nullptr;
  xmlNode* holding_ = nullptr;
  /// Ids of elements that nothing needs once the group is removed.
  std::vector<std::string> unused_;
};

}  // namespace

void check_restorable(SvgDocument& document, const MeshObject& group) {
  ShapeRestorer(document, group).check();
}

MeshObject restore_shape(SvgDocument& document, const MeshObject& group) {
  return ShapeRestorer(document, group).run();
}

}  // namespace gradmesh
