#include "io/svg_write.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "io/block_outline.h"
#include "io/svg_gradient_writer.h"
#include "io/svg_group.h"
#include "io/svg_number.h"
#include "io/svg_paint.h"
#include "io/xml_edit.h"
#include "io/xml_node.h"

namespace gradmesh {
namespace {

struct Bounds {
  glm::dvec2 low{std::numeric_limits<double>::infinity()};
  glm::dvec2 high{-std::numeric_limits<double>::infinity()};
};

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
    std::vector<std::string> gradients;
    for (xmlNode* path : child_elements(group)) {
      if (!attribute(path, "face", gradmesh_namespace)) continue;
      if (const auto fill = document_.styles().declared(path, "fill")) {
        if (const auto id = referenced_id(*fill)) gradients.push_back(*id);
        fallback_ = fallback_color(*fill);
      }
      remove_node(path);
    }
    write_blocks(group, group->children);
    describe_group(group);
    for (const std::string& id : gradients) remove_if_unused(document_, id);
  }

  void replace_shape() {
    xmlNode* shape = object_.node;
    const std::string gradient = attribute(object_.gradient, "id").value_or("");
    if (const auto paint = document_.styles().inherited(shape, is_stroke() ? "stroke" : "fill"))
      fallback_ = fallback_color(*paint);
    xmlNode* outer = xmlNewNode(shape->ns, reinterpret_cast<const xmlChar*>("g"));
    xmlAddPrevSibling(shape, outer);
    move_group_attributes(document_.styles(), shape, outer);

    // One group, so that a double click is enough to get at the blocks, unless what else the object
    // paints, or an effect that comes before clipping, needs a group of its own.
    const bool other_paint = paints_otherwise();
    const bool nested = other_paint || has_effects(document_.styles(), outer);
    xmlNode* group = nested ? add_child(outer, "g") : outer;
    if (nested) set_attribute(outer, "outer", "1", gradmesh_namespace, "gradmesh");
    if (const auto opacity = document_.styles().declared(shape, "fill-opacity"))
      if (!is_stroke()) set_style(group, "fill-opacity", *opacity);
    const Bounds bounds = write_blocks(group, nullptr);
    hold(group, shape, bounds);
    describe_group(group);

    xmlUnlinkNode(shape);
    if (other_paint) {
      keep_other_paint(shape, outer, group);
    } else {
      xmlFreeNode(shape);
    }
    document_.set_id(outer, id_);
    remove_if_unused(document_, gradient);
  }

  bool is_stroke() const { return object_.role == PaintRole::stroke; }

  bool paints_otherwise() const {
    const char* other = is_stroke() ? "fill" : "stroke";
    const std::string otherwise = is_stroke() ? "black" : "none";
    return document_.styles().inherited(object_.node, other).value_or(otherwise) != "none";
  }

  /// The shape itself without the paint that is now in blocks; a stroke above them, a fill below,
  /// unless paint-order turns that round.
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
  void hold(xmlNode* group, const xmlNode* shape, const Bounds& bounds) {
    xmlNode* holder = add_child(defs_, is_stroke() ? "mask" : "clipPath");
    const std::string id = document_.give_id(holder, id_ + "-shape");
    xmlNode* copy = geometry_copy(document_.styles(), shape, holder);
    if (is_stroke()) {
      set_attribute(holder, "maskUnits", "userSpaceOnUse");
      set_attribute(holder, "x", format_number(bounds.low.x, 6));
      set_attribute(holder, "y", format_number(bounds.low.y, 6));
      set_attribute(holder, "width", format_number(bounds.high.x - bounds.low.x, 6));
      set_attribute(holder, "height", format_number(bounds.high.y - bounds.low.y, 6));
      paint_stroke_white(document_.styles(), shape, copy);
      set_attribute(group, "mask", "url(#" + id + ")");
    } else {
      set_attribute(holder, "clipPathUnits", "userSpaceOnUse");
      set_clip_rule(document_.styles(), shape, copy);
      set_attribute(group, "clip-path", "url(#" + id + ")");
    }
  }

  void describe_group(xmlNode* group) {
    const auto own = [&](xmlNode* node, const char* name, const std::string& value) {
      set_attribute(node, name, value, gradmesh_namespace, "gradmesh");
    };
    own(group, "version", "1");
    own(group, "role", is_stroke() ? "stroke" : "fill");
    own(group, "patches-before", std::to_string(written_.patches_before));
    own(group, "curves", format_curves(written_.mesh, written_.blocks));
    set_attribute(group, "label", written_.label, inkscape_namespace, "inkscape");
    // The group around it, where there is one, is what the person sees first.
    xmlNode* outer = parent_element(group);
    if (outer && attribute(outer, "outer", gradmesh_namespace))
      set_attribute(outer, "label", written_.label, inkscape_namespace, "inkscape");
  }

  /// The blocks as paths, before `before` or at the end; their common bounds.
  Bounds write_blocks(xmlNode* group, xmlNode* before) {
    const double margin = seam_margin();
    Bounds bounds;
    int face = 0;
    for (const Block& block : written_.blocks) {
      const std::string gradient = write_block_gradient(document_, defs_, written_.mesh, block,
                                                        written_.coons_tolerance, id_ + "-mesh");
      xmlNode* path = add_child(group, "path");
      if (before) xmlAddPrevSibling(before, path);
      document_.give_id(path, id_ + "-block");
      const std::vector<glm::dvec2> outline = grown_outline(written_.mesh, block, margin);
      for (const glm::dvec2 p : outline) {
        bounds.low = glm::min(bounds.low, p);
        bounds.high = glm::max(bounds.high, p);
      }
      set_attribute(path, "d", path_data(outline));
      set_attribute(path, "style", block_style(gradient));
      set_attribute(path, "face", std::to_string(face), gradmesh_namespace, "gradmesh");
      face += int(block.cells.size());
    }
    return bounds;
  }

  std::string block_style(const std::string& gradient) const {
    std::string style = "fill:url(#" + gradient + ")";
    if (!fallback_.empty()) style += " " + fallback_;
    style += ";fill-rule:nonzero;stroke:none";
    // A stroke's opacity is in its mask; a fill's is inherited from the group.
    if (is_stroke()) style += ";fill-opacity:1";
    return style;
  }

  static std::string path_data(const std::vector<glm::dvec2>& polygon) {
    std::string d;
    for (const glm::dvec2 p : polygon) d += (d.empty() ? "M " : " L ") + format_point(p, 6);
    return d + " Z";
  }

  /// Enough that a path's smoothed edge stays off the mesh even where the whole mesh is shown as
  /// small as 50 pixels.
  double seam_margin() const {
    Bounds bounds;
    for (const Point p : written_.mesh.points()) {
      bounds.low = glm::min(bounds.low, written_.mesh.position(p));
      bounds.high = glm::max(bounds.high, written_.mesh.position(p));
    }
    const glm::dvec2 size = bounds.high - bounds.low;
    return 0.02 * std::max(size.x, size.y);
  }

  SvgDocument& document_;
  const MeshObject& object_;
  const WrittenMesh& written_;
  xmlNode* defs_;
  const std::string id_;
  /// What programs that know no meshes paint instead.
  std::string fallback_;
};

}  // namespace

void write_mesh(SvgDocument& document, const MeshObject& object, const WrittenMesh& written) {
  MeshWriter(document, object, written).run();
}

}  // namespace gradmesh
