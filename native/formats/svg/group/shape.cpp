#include "formats/svg/group/shape.h"

#include <algorithm>
#include <string>
#include <vector>

#include "formats/svg/tree/own.h"
#include "formats/svg/tree/paint.h"
#include "formats/svg/tree/unused.h"
#include "formats/svg/values/mesh_names.h"
#include "formats/svg/values/reference.h"
#include "formats/svg/xml/node.h"
#include "formats/text/number.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

class ShapeReplacer {
 public:
  ShapeReplacer(SvgTree& tree, const MeshObject& object)
      : tree_(tree),
        object_(object),
        defs_(tree.defs_around(object.node)),
        id_(object_id(object.node)) {}

  void run(bool may_be_masked, const AddContent& add_content) {
    xmlNode* shape = object_.node;
    const std::string gradient = attribute(object_.gradient, "id").value_or("");
    const std::string fill_opacity = tree_.styles().inherited(shape, "fill-opacity").value_or("1");
    // As long as it is where it is, since rules may follow its place.
    const bool other_paint = paints_otherwise();
    Declarations said = said_by_rules(tree_.styles(), shape);
    // Not the shape's own namespace, which it may declare itself and take away with it.
    xmlNode* outer = add_child(parent_element(shape), "g");
    xmlAddPrevSibling(shape, outer);
    keep_said(tree_.styles(), said, shape);
    move_group_attributes(tree_.styles(), shape, outer);
    std::erase_if(said, [](const auto& one) { return is_effect(one.first); });
    keep_said(tree_.styles(), said, shape);

    // One group, so that a double click is enough to get at the content, unless what else the
    // object paints, or an effect that comes before clipping, needs a group of its own. A group has
    // one mask: a stroke's goes around that of the opacities.
    const bool two_masks = is_stroke() && may_be_masked;
    const bool nested = other_paint || has_effects(tree_.styles(), outer);
    xmlNode* holder = nested ? add_inner_group(outer) : outer;
    xmlNode* group = two_masks ? add_inner_group(holder) : holder;
    if (!is_stroke()) multiply_opacity(group, fill_opacity);
    const Box box = add_content(group);
    hold(holder, shape, box);

    xmlUnlinkNode(shape);
    keep_said(tree_.styles(), said, shape);
    if (other_paint) {
      keep_other_paint(shape, outer, holder);
      for (const char* paint : {"fill", "stroke"}) said.erase(paint);
      keep_said(tree_.styles(), said, shape);
    } else {
      xmlFreeNode(shape);
    }
    tree_.set_id(outer, id_);
    remove_if_unused(tree_, gradient);
  }

 private:
  /// Adds a group in `outer`, and marks `outer` as the whole object.
  xmlNode* add_inner_group(xmlNode* outer) const {
    set_own_attribute(outer, "outer", "1");
    xmlNode* group = add_child(outer, "g");
    turn_off_effects(tree_.styles(), group);
    return group;
  }

  /// Multiplies the group's opacity by that of the fill, which must not act on each block by
  /// itself.
  void multiply_opacity(xmlNode* group, const std::string& by) {
    const auto factor = parse_opacity(by);
    if (!factor || *factor == 1) return;
    const std::string own = tree_.styles().declared(group, "opacity").value_or("1");
    set_style(tree_.styles(), group, "opacity",
              format_number(parse_opacity(own).value_or(1) * *factor, 6));
  }

  bool is_stroke() const { return object_.role == PaintRole::stroke; }

  bool paints_otherwise() const {
    const char* other = is_stroke() ? "fill" : "stroke";
    const std::string otherwise = is_stroke() ? "black" : "none";
    const auto shows = [&](const char* property, const std::string& initial) {
      return tree_.styles().inherited(object_.node, property).value_or(initial) != "none";
    };
    return shows(other, otherwise) || shows("marker-start", "none") ||
           shows("marker-mid", "none") || shows("marker-end", "none") || shows("marker", "none");
  }

  /// Keeps the shape without the paint that is now in blocks: a stroke above the blocks, a fill
  /// below, unless paint-order reverses that.
  void keep_other_paint(xmlNode* shape, xmlNode* outer, xmlNode* group) {
    const std::string order = tree_.styles().inherited(shape, "paint-order").value_or("normal");
    const bool stroke_first = order.find("stroke") < order.find("fill");
    keep_only_paint(tree_.styles(), shape, is_stroke() ? "fill" : "stroke");
    if (is_stroke() == stroke_first) {
      xmlAddChild(outer, shape);
    } else {
      xmlAddPrevSibling(group, shape);
    }
    tree_.give_id(shape, id_ + (is_stroke() ? "-fill" : "-stroke"));
  }

  /// Clips the group by the shape or masks it by its stroke.
  void hold(xmlNode* group, const xmlNode* shape, const Box& box) {
    xmlNode* holder = add_child(defs_, is_stroke() ? "mask" : "clipPath");
    const std::string id = tree_.give_id(holder, id_ + "-shape");
    xmlNode* copy = geometry_copy(tree_.styles(), shape, holder);
    if (is_stroke()) {
      set_mask_region(holder, box);
      paint_stroke_white(tree_.styles(), shape, copy);
      set_attribute(group, "mask", paint_by(id));
    } else {
      set_attribute(holder, "clipPathUnits", "userSpaceOnUse");
      set_clip_rule(tree_.styles(), shape, copy);
      set_attribute(group, "clip-path", paint_by(id));
    }
  }

  SvgTree& tree_;
  const MeshObject& object_;
  xmlNode* defs_;
  const std::string id_;
};

class ShapeRestorer {
 public:
  ShapeRestorer(SvgTree& tree, const MeshObject& object)
      : tree_(tree),
        group_(object.node),
        outermost_(whole_object(object.node)),
        role_(object.role),
        id_(object_id(object.node)) {}

  void check() {
    if (std::ranges::count_if(elements_from(outermost_), is_mesh_group) > 1)
      fail(group_, Message("the fill and the stroke of its object are both made of blocks"));
    find_holder();
  }

  MeshObject run() {
    check();
    // Inkscape 1.2 ends where what clips or masks a cloned object is gone with the object.
    const bool has_clone = is_cloned(tree_, outermost_);
    xmlNode* shape = take_shape();
    xmlAddPrevSibling(outermost_, shape);
    const std::string fallback = collect_gradients();
    give_group_attributes(shape);

    xmlNode* gradient = add_child(tree_.defs(), mesh_gradient_name);
    set_attribute(gradient, "gradientUnits", "userSpaceOnUse");
    const std::string name = tree_.give_id(gradient, id_ + "-mesh");
    set_style(tree_.styles(), shape, paint_name(role_), paint_by(name, fallback));

    remove_node(outermost_);
    if (!has_clone)
      for (const std::string& unused : unused_) remove_if_unused(tree_, unused);
    tree_.set_id(shape, id_);
    return {shape, id_, role_, gradient};
  }

 private:
  bool is_stroke() const { return role_ == PaintRole::stroke; }
  const char* holding_attribute() const { return is_stroke() ? "mask" : "clip-path"; }

  /// Finds the innermost group that the object's shape clips or masks, which an opacity mask does
  /// not. Throws InputError if there is none.
  void find_holder() {
    for (xmlNode* node = group_; !holding_; node = parent_element(node)) {
      xmlNode* found = referenced(tree_, attribute(node, holding_attribute()));
      if (found && !own_attribute(found, "opacity")) {
        holder_ = node;
        holding_ = found;
      }
      if (node == outermost_) break;
    }
    const auto held = holding_ ? child_elements(holding_) : std::vector<xmlNode*>();
    if (held.size() != 1 || !can_paint(held.front(), role_))
      fail(group_, Message("its {0} no longer holds its shape", holding_attribute()));
    unused_.push_back(attribute(holding_, "id").value_or(""));
    if (const xmlNode* mask = opacity_mask(tree_, group_))
      unused_.push_back(attribute(mask, "id").value_or(""));
  }

  /// Takes the shape out of the document and returns it: the object that paints beside the blocks
  /// if there is one, otherwise the content of the clip path or mask.
  xmlNode* take_shape() {
    xmlNode* shape = nullptr;
    for (xmlNode* child : child_elements(outermost_)) {
      if (!is_block(child) && can_paint(child, role_)) shape = child;
    }
    if (!shape) {
      shape = child_elements(holding_).front();
      const std::string rule = take_style(shape, "clip-rule");
      if (!rule.empty()) set_style(tree_.styles(), shape, "fill-rule", rule);
    }
    xmlUnlinkNode(shape);
    return shape;
  }

  void give_group_attributes(xmlNode* shape) {
    // Inside another group its opacity is that of the paint alone.
    if (group_ != outermost_) {
      const std::string opacity = take_style(group_, "opacity");
      if (!opacity.empty())
        set_style(tree_.styles(), shape, paint_name(role_) + std::string("-opacity"), opacity);
    }
    if (holder_ == outermost_) remove_attribute(outermost_, holding_attribute());
    if (group_ == outermost_ && opacity_mask(tree_, group_)) remove_attribute(group_, "mask");
    // A label that the person has given stays.
    if (attribute(outermost_, "label", inkscape_namespace) == own_attribute(group_, "label"))
      remove_attribute(outermost_, "label", inkscape_namespace);
    return_group_attributes(tree_.styles(), outermost_, shape);
  }

  /// Adds the gradients of the blocks to `unused_`. Returns the colour for programs that know no
  /// meshes.
  std::string collect_gradients() {
    std::string fallback;
    for (const xmlNode* path : child_elements(group_)) {
      if (!is_block(path)) continue;
      const auto fill = tree_.styles().declared(path, "fill");
      const auto id = fill ? referenced_id(*fill, tree_.name()) : std::nullopt;
      if (id) unused_.push_back(*id);
      if (fill) fallback = fallback_color(*fill);
    }
    if (const xmlNode* mask = opacity_mask(tree_, group_))
      for (const xmlNode* path : child_elements(mask))
        if (const auto fill = tree_.styles().declared(path, "fill"))
          if (const auto id = referenced_id(*fill, tree_.name())) unused_.push_back(*id);
    return fallback;
  }

  SvgTree& tree_;
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

void set_box(xmlNode* node, const Box& box, int digits) {
  set_attribute(node, "x", format_number(box.low().x, digits));
  set_attribute(node, "y", format_number(box.low().y, digits));
  set_attribute(node, "width", format_number(box.size().x, digits));
  set_attribute(node, "height", format_number(box.size().y, digits));
}

void set_mask_region(xmlNode* mask, const Box& box) {
  set_attribute(mask, "maskUnits", "userSpaceOnUse");
  set_box(mask, box, digits_within(box, outline_digits));
}

void replace_shape(SvgTree& tree, const MeshObject& object, bool may_be_masked,
                   const AddContent& add_content) {
  ShapeReplacer(tree, object).run(may_be_masked, add_content);
}

void check_restorable(SvgTree& tree, const MeshObject& group) {
  ShapeRestorer(tree, group).check();
}

MeshObject restore_shape(SvgTree& tree, const MeshObject& group) {
  return ShapeRestorer(tree, group).run();
}

}  // namespace gradmesh
