#include "formats/svg/tree/visible.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "formats/svg/tree/own.h"
#include "formats/svg/tree/paint.h"
#include "formats/svg/tree/unused.h"
#include "formats/svg/values/shape.h"
#include "formats/svg/values/transform.h"
#include "formats/svg/xml/node.h"
#include "formats/text/excerpt.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

using Shapes = std::vector<FilledOutline>;

/// Returns the map from an element's user space to that around it; nothing if it is not known.
std::optional<Affine> placed(const xmlNode* node) {
  const auto text = attribute(node, "transform");
  return text ? parse_transform(*text) : Affine();
}

/// Returns by which rule a shape is filled, or clips; property: "fill-rule" or "clip-rule".
FillRule fill_rule(const SvgTree& tree, const xmlNode* shape, const char* property) {
  return tree.styles().inherited(shape, property) == "evenodd" ? FillRule::evenodd
                                                               : FillRule::nonzero;
}

class VisibleFinder {
 public:
  VisibleFinder(const SvgTree& tree, const MeshObject& object) : tree_(tree), object_(object) {}

  VisibleArea run() {
    if (object_.gradient && object_.role == PaintRole::fill)
      if (auto outline = shape_outline(object_.node))
        area_.sets.push_back({{*std::move(outline), fill_rule(tree_, object_.node, "fill-rule")}});
    Affine to_object;
    for (const xmlNode* node = object_.node; node && stays_in_place(node);
         node = parent_element(node)) {
      add(held_by(node, "clip-path", "clipPathUnits"), "clip-rule", to_object);
      add(held_by(node, "mask", "maskContentUnits"), "fill-rule", to_object);
      const auto place = placed(node);
      if (!place || place->determinant() == 0 || is_used_elsewhere(node)) break;
      to_object = to_object * place->inverse();
    }
    return std::move(area_);
  }

 private:
  /// Returns true if the surroundings of the element are painted where they stand in the document.
  bool stays_in_place(const xmlNode* node) const {
    const std::string_view name = svg_name(node);
    return node == object_.node || name == "g" || name == "a" || name == "switch";
  }

  bool is_used_elsewhere(const xmlNode* node) const {
    const auto id = attribute(node, "id");
    return id && is_used(tree_, *id);
  }

  /// Returns the clip path or mask of the element, if its coordinates are the element's; else null.
  const xmlNode* held_by(const xmlNode* node, const char* property, const char* units) const {
    const xmlNode* holder = referenced(tree_, tree_.styles().declared(node, property));
    if (!holder || svg_name(holder) != (property == std::string("mask") ? "mask" : "clipPath"))
      return nullptr;
    const bool own_units = attribute(holder, units).value_or("userSpaceOnUse") == "userSpaceOnUse";
    const bool moved = attribute(holder, "transform").has_value();
    return own_units && !moved ? holder : nullptr;
  }

  /// Limits the area to the shapes in a clip path or mask, if all of them are known.
  void add(const xmlNode* holder, const char* rule_property, const Affine& to_object) {
    // The mask of a mesh's opacities holds all of its blocks.
    if (!holder || own_attribute(holder, "opacity")) return;
    Shapes shapes;
    for (const xmlNode* child : child_elements(holder))
      if (!collect(child, rule_property, to_object, shapes)) return;
    area_.sets.push_back(std::move(shapes));
  }

  /// Adds the shapes of the element to `shapes`. Returns false if it is not known where the element
  /// may paint.
  bool collect(const xmlNode* node, const char* rule_property, const Affine& around,
               Shapes& shapes) const {
    const std::string_view name = svg_name(node);
    if (name == "title" || name == "desc" || name == "metadata" || name == "defs") return true;
    const auto place = placed(node);
    const StyleSheet& styles = tree_.styles();
    if (!place || styles.declared(node, "filter").value_or("none") != "none") return false;
    const Affine to_object = around * *place;
    if (name == "g") {
      for (const xmlNode* child : child_elements(node))
        if (!collect(child, rule_property, to_object, shapes)) return false;
      return true;
    }
    const bool clips = rule_property == std::string("clip-rule");
    if (!clips && styles.inherited(node, "stroke").value_or("none") != "none") return false;
    auto outline = shape_outline(node);
    if (!outline) return false;
    shapes.push_back(
        {mapped(*std::move(outline), to_object), fill_rule(tree_, node, rule_property)});
    return true;
  }

  const SvgTree& tree_;
  const MeshObject& object_;
  VisibleArea area_;
};

}  // namespace

std::optional<VisibleArea> visible_area(const SvgTree& tree, const MeshObject& object) {
  VisibleArea area = VisibleFinder(tree, object).run();
  if (area.sets.empty()) return std::nullopt;
  return area;
}

namespace {

void add_shapes(const SvgTree& tree, const xmlNode* node, Shapes& shapes) {
  if (auto outline = shape_outline(node)) {
    shapes.push_back(
        {mapped(*std::move(outline), to_document(node)), fill_rule(tree, node, "fill-rule")});
  }
  for (const xmlNode* child : child_elements(node)) add_shapes(tree, child, shapes);
}

}  // namespace

std::vector<FilledOutline> covered_area(const SvgTree& tree, const std::string& id) {
  const xmlNode* const node = tree.find(id);
  if (!node) throw InputError("{0}: there is no object with the id {1}.", tree.name(), excerpt(id));
  Shapes shapes;
  add_shapes(tree, node, shapes);
  if (shapes.empty())
    throw InputError("{0}: {1} is no shape, so it covers nothing.", tree.name(), excerpt(id));
  return shapes;
}

std::optional<Box> stroke_reach(const SvgTree& tree, const MeshObject& object) {
  if (object.is_group() || object.role != PaintRole::stroke) return std::nullopt;
  const auto box = shape_box(object.node);
  const auto value = [&](const char* property, const char* otherwise) {
    return tree.styles().inherited(object.node, property).value_or(otherwise);
  };
  const auto width = parse_length(value("stroke-width", "1"), std::nullopt);
  const auto limit = parse_length(value("stroke-miterlimit", "4"), std::nullopt);
  if (!box || box->empty() || !width || !limit || value("vector-effect", "none") != "none")
    return std::nullopt;
  // Corners of mitres and of square caps are farthest from the line.
  const double farthest = std::max(std::numbers::sqrt2, *limit);
  const glm::dvec2 reach(std::abs(*width) / 2 * farthest);
  Box all;
  all.add(box->low() - reach);
  all.add(box->high() + reach);
  return all;
}

bool fills_shape(const MeshObject& object) {
  return !object.is_group() && object.role == PaintRole::fill && shape_outline(object.node);
}

}  // namespace gradmesh
