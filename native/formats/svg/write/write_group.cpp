#include "formats/svg/write/write_group.h"

#include "formats/svg/read/curves.h"
#include "formats/svg/read/paint.h"
#include "formats/svg/read/read_group.h"
#include "formats/svg/write/memory.h"
#include "formats/svg/write/write_blocks.h"
#include "formats/svg/write/write_gradient.h"
#include "formats/svg/xml/edit.h"
#include "formats/svg/xml/node.h"
#include "formats/text/number.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

class MeshWriter {
 public:
  MeshWriter(SvgDocument& document, const MeshObject& object, const WrittenMesh& written)
      : document_(document),
        object_(object),
        written_(written),
        defs_(find_defs()),
        id_(object_id(object.node)) {}

  void run() {
    if (is_mesh_group(object_.node)) {
      renew_group();
    } else {
      replace_shape();
    }
  }

 private:
  xmlNode* find_defs() {
    const auto found = child_elements(document_.root(), "defs");
    if (!found.empty()) return found.front();
    xmlNode* defs = add_child(document_.root(), "defs");
    xmlNode* first = document_.root()->children;
    if (first != defs) xmlAddPrevSibling(first, defs);
    return defs;
  }

  void renew_group() {
    xmlNode* group = object_.node;
    remove_opacity_mask(group);
    const BlockIds ids = written_.keeps_faces ? block_ids(group) : BlockIds();
    // The gradients go first, so that their ids are free.
    for (const std::string& id : remove_blocks(group)) remove_if_unused(document_, id);
    write_blocks(group, group->children, ids);
    describe_group(group);
  }

  /// Returns the ids of the blocks that hold all faces of the mesh; nothing if others do as well.
  BlockIds block_ids(const xmlNode* group) const {
    BlockIds ids;
    int all = 0;
    for (const auto& [path, faces] : block_faces(document_, group)) {
      const auto fill = document_.styles().declared(path, "fill");
      const int count = faces.rows * faces.columns;
      ids[{faces.first, count}] = {attribute(path, "id").value_or(""),
                                   referenced_id(fill.value_or("")).value_or("")};
      all += count;
    }
    return all == written_.mesh.face_count() ? ids : BlockIds();
  }

  /// Removes the blocks in a group or mask. Returns the ids of the gradients that they used.
  std::vector<std::string> remove_blocks(xmlNode* parent) {
    std::vector<std::string> gradients;
    for (xmlNode* path : child_elements(parent)) {
      if (!attribute(path, "face", gradmesh_namespace)) continue;
      if (const auto fill = document_.styles().declared(path, "fill")) {
        if (const auto id = referenced_id(*fill)) gradients.push_back(*id);
        fallback_ = fallback_color(*fill);
      }
      remove_node(path);
    }
    return gradients;
  }

  void remove_opacity_mask(xmlNode* group) {
    xmlNode* mask = opacity_mask(document_, group);
    if (!mask) return;
    remove_attribute(group, "mask");
    // A copy of the group may use it too.
    if (is_used(document_, attribute(mask, "id").value_or(""))) return;
    const std::vector<std::string> gradients = remove_blocks(mask);
    remove_node(mask);
    for (const std::string& id : gradients) remove_if_unused(document_, id);
  }

  void replace_shape() {
    xmlNode* shape = object_.node;
    const std::string gradient = attribute(object_.gradient, "id").value_or("");
    if (const auto paint = document_.styles().inherited(shape, is_stroke() ? "stroke" : "fill"))
      fallback_ = fallback_color(*paint);
    const std::string fill_opacity =
        document_.styles().inherited(shape, "fill-opacity").value_or("1");
    // Not the shape's own namespace, which it may declare itself and take away with it.
    xmlNode* outer = add_child(parent_element(shape), "g");
    xmlAddPrevSibling(shape, outer);
    move_group_attributes(document_.styles(), shape, outer);

    // One group, so that a double click is enough to get at the blocks, unless what else the object
    // paints, or an effect that comes before clipping, needs a group of its own. A group has one
    // mask: a stroke's goes around that of the opacities.
    const bool other_paint = paints_otherwise();
    const bool two_masks = is_stroke() && is_translucent(written_.mesh);
    const bool nested = other_paint || has_effects(document_.styles(), outer);
    xmlNode* holder = nested ? add_inner_group(outer) : outer;
    xmlNode* group = two_masks ? add_inner_group(holder) : holder;
    if (!is_stroke()) multiply_opacity(group, fill_opacity);
    const Box box = write_blocks(group, nullptr);
    hold(holder, shape, box);
    describe_group(group);

    xmlUnlinkNode(shape);
    if (other_paint) {
      keep_other_paint(shape, outer, holder);
    } else {
      xmlFreeNode(shape);
    }
    document_.set_id(outer, id_);
    remove_if_unused(document_, gradient);
  }

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

  static void set_mask_region(xmlNode* mask, const Box& box) {
    const int digits = digits_within(box, outline_digits);
    set_attribute(mask, "maskUnits", "userSpaceOnUse");
    set_attribute(mask, "x", format_number(box.low().x, digits));
    set_attribute(mask, "y", format_number(box.low().y, digits));
    set_attribute(mask, "width", format_number(box.size().x, digits));
    set_attribute(mask, "height", format_number(box.size().y, digits));
  }

  void describe_group(xmlNode* group) {
    const auto own = [&](const char* name, const std::string& value) {
      if (value.empty())
        remove_attribute(group, name, gradmesh_namespace);
      else
        set_attribute(group, name, value, gradmesh_namespace, "gradmesh");
    };
    own("version", "1");
    own("role", is_stroke() ? "stroke" : "fill");
    own("handles-before", written_.before.handles ? std::to_string(written_.before.handles) : "");
    own("patches-before", std::to_string(written_.before.patches));
    own("curves", format_curves(written_.mesh, written_.form.blocks));
    own("original", written_.original);
    own("written", remember_blocks(written_.mesh, written_.form));
    own("label", written_.label);
    set_attribute(group, "label", written_.label, inkscape_namespace, "inkscape");
    // The group around it, where there is one, is what the person sees first.
    for (xmlNode* outer = parent_element(group);
         outer && attribute(outer, "outer", gradmesh_namespace); outer = parent_element(outer))
      set_attribute(outer, "label", written_.label, inkscape_namespace, "inkscape");
  }

  /// Writes the blocks and, if they do not hold the opacities, the mask that does. Returns the box
  /// around the blocks' paths.
  Box write_blocks(xmlNode* group, xmlNode* before, const BlockIds& ids = {}) {
    const BlocksWriter writer(document_, defs_, written_, id_, fallback_);
    const Box box = writer.write(
        group, before, written_.form.masks_opacity ? MeshChannel::color : MeshChannel::both, ids);
    if (written_.form.masks_opacity) {
      xmlNode* mask = add_child(defs_, "mask");
      const std::string id = document_.give_id(mask, id_ + "-opacity-mask");
      set_attribute(mask, "opacity", "1", gradmesh_namespace, "gradmesh");
      set_mask_region(mask, box);
      writer.write(mask, nullptr, MeshChannel::opacity);
      set_attribute(group, "mask", "url(#" + id + ")");
    }
    return box;
  }

  SvgDocument& document_;
  const MeshObject& object_;
  const WrittenMesh& written_;
  xmlNode* defs_;
  const std::string id_;
  /// The colour that programs that know no meshes paint instead.
  std::string fallback_;
};

}  // namespace

void write_mesh(SvgDocument& document, const MeshObject& object, const WrittenMesh& written) {
  MeshWriter(document, object, written).run();
}

}  // namespace gradmesh
