#include "formats/svg/write/replace_shape.h"

#include <string>

#include "formats/svg/read/paint.h"
#include "formats/svg/read/read_group.h"
#include "formats/svg/xml/edit.h"
#include "formats/svg/xml/node.h"
#include "formats/text/number.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

class ShapeReplacer {
 public:
  ShapeReplacer(SvgDocument& document, const MeshObject& object)
      : document_(document), object_(object), defs_(document.defs()), id_(object_id(object.node)) {}

  void run(bool may_be_masked, const AddContent& add_content) {
    xmlNode* shape = object_.node;
    const std::string gradient = attribute(object_.gradient, "id").value_or("");
    const std::string fill_opacity =
        document_.styles().inherited(shape, "fill-opacity").value_or("1");
    // Not the shape's own namespace, which it may declare itself and take away with it.
    xmlNode* outer = add_child(parent_element(shape), "g");
    xmlAddPrevSibling(shape, outer);
    move_group_attributes(document_.styles(), shape, outer);

    // One group, so that a double click is enough to get at the content, unless what else the
    // object paints, or an effect that comes before clipping, needs a group of its own. A group has
    // one mask: a stroke's goes around that of the opacities.
    const bool other_paint = paints_otherwise();
    const bool two_masks = is_stroke() && may_be_masked;
    const bool nested = other_paint || has_effects(document_.styles(), outer);
    xmlNode* holder = nested ? add_inner_group(outer) : outer;
    xmlNode* group = two_masks ? add_inner_group(holder) : holder;
    if (!is_stroke()) multiply_opacity(group, fill_opacity);
    const Box box = add_content(group);
    hold(holder, shape, box);

    xmlUnlinkNode(shape);
    if (other_paint) {
      keep_other_paint(shape, outer, holder);
    } else {
      xmlFreeNode(shape);
    }
    document_.set_id(outer, id_);
    remove_if_unused(document_, gradient);
  }

 private:
  /// Adds a group in `outer`, and marks `outer` as the whole object.
  static xmlNode* add_inner_group(xmlNode* outer) {
    set_attribute(outer, "outer", "1", gradmesh_namespace, "gradmesh");
    return add_child(outer, "g");
  }

  /// Multiplies the group's opacity by that of the fill, which must not act on each block by
  /// itself.
  void multiply_opacity(xmlNode* group, const std::string& by) {
    const auto factor = parse_opacity(by);
    if (!factor || *factor == 1) return;
    const std::string own = document_.styles().declared(group, "opacity").value_or("1");
    set_style(group, "opacity", format_number(parse_opacity(own).value_or(1) * *factor, 6));
  }

  bool is_stroke() const { return object_.role == PaintRole::stroke; }

  bool paints_otherwise() const {
    const char* other = is_stroke() ? "fill" : "stroke";
    const std::string otherwise = is_stroke() ? "black" : "none";
    return document_.styles().inherited(object_.node, other).value_or(otherwise) != "none";
  }

  /// Keeps the shape without the paint that is now in blocks: a stroke above the blocks, a fill
  /// below, unless paint-order reverses that.
  void keep_other_paint(xmlNode* shape, xmlNode* outer, xmlNode* group) {
    const std::string order = document_.styles().inherited(shape, "paint-order").value_or("normal");
    const bool stroke_first = order.find("stroke") < order.find("fill");
    keep_only_paint(document_.styles(), shape, is_stroke() ? "fill" : "stroke");
    if (is_stroke() == stroke_first) {
      xmlAddChild(outer, shape);
    } else {
      xmlAddPrevSibling(group, shape);
    }
    document_.give_id(shape, id_ + (is_stroke() ? "-fill" : "-stroke"));
  }

  /// Clips the group by the shape or masks it by its stroke.
  void hold(xmlNode* group, const xmlNode* shape, const Box& box) {
    xmlNode* holder = add_child(defs_, is_stroke() ? "mask" : "clipPath");
    const std::string id = document_.give_id(holder, id_ + "-shape");
    xmlNode* copy = geometry_copy(document_.styles(), shape, holder);
    if (is_stroke()) {
      set_mask_region(holder, box);
      paint_stroke_white(document_.styles(), shape, copy);
      set_attribute(group, "mask", "url(#" + id + ")");
    } else {
      set_attribute(holder, "clipPathUnits", "userSpaceOnUse");
      set_clip_rule(document_.styles(), shape, copy);
      set_attribute(group, "clip-path", "url(#" + id + ")");
    }
  }

  SvgDocument& document_;
  const MeshObject& object_;
  xmlNode* defs_;
  const std::string id_;
};

}  // namespace

void set_mask_region(xmlNode* mask, const Box& box) {
  const int digits = digits_within(box, outline_digits);
  set_attribute(mask, "maskUnits", "userSpaceOnUse");
  set_attribute(mask, "x", format_number(box.low().x, digits));
  set_attribute(mask, "y", format_number(box.low().y, digits));
  set_attribute(mask, "width", format_number(box.size().x, digits));
  set_attribute(mask, "height", format_number(box.size().y, digits));
}

void replace_shape(SvgDocument& document, const MeshObject& object, bool may_be_masked,
                   const AddContent& add_content) {
  ShapeReplacer(document, object).run(may_be_masked, add_content);
}

}  // namespace gradmesh
