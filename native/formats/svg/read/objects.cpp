#include "formats/svg/read/objects.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>

#include "formats/svg/read/read_group.h"
#include "formats/svg/values/mesh_names.h"
#include "formats/svg/values/transform.h"
#include "formats/svg/xml/node.h"
#include "formats/text/excerpt.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

constexpr std::array<std::string_view, 4> containers{"svg", "g", "a", "switch"};
/// Elements whose contents are painted where something names the element or, for <defs>, its
/// contents.
constexpr std::array<std::string_view, 5> definitions{"defs", "symbol", "pattern", "mask",
                                                      "marker"};
constexpr std::array<std::string_view, 8> paintables{"path", "rect",     "circle",  "ellipse",
                                                     "line", "polyline", "polygon", "text"};

bool contains(const auto& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Adds to `ids` the ids that the texts of a list name as `#id`. Entities name nothing.
void find_named_in(const xmlNode* texts, std::set<std::string>& ids) {
  for (const xmlNode* node = texts; node; node = node->next) {
    const bool is_text = node->type == XML_TEXT_NODE || node->type == XML_CDATA_SECTION_NODE;
    if (!is_text || !node->content) continue;
    const std::string_view text = reinterpret_cast<const char*>(node->content);
    for (std::size_t at = text.find('#'); at != text.npos; at = text.find('#', at + 1)) {
      const std::string_view rest = text.substr(at + 1);
      ids.emplace(rest.substr(0, rest.find_first_of(")'\"; \t\r\n")));
    }
  }
}

/// Adds to `ids` the ids that attributes and rules of the element and of all below it name.
void find_named(const xmlNode* node, std::set<std::string>& ids) {
  for (const xmlAttr* a = node->properties; a; a = a->next) find_named_in(a->children, ids);
  if (svg_name(node) == "style") find_named_in(node->children, ids);
  for (const xmlNode* child : child_elements(node)) find_named(child, ids);
}

/// The properties in force at an element.
struct Context {
  /// The mesh gradients for fill and stroke; null where the paint is anything else.
  xmlNode* fill = nullptr;
  xmlNode* stroke = nullptr;
  /// The hidden original around the element, as in MeshObject::kept.
  const xmlNode* kept = nullptr;
  /// True if the element is painted; false if it is inside a definition that nothing names.
  bool shown = true;
};

class Collector {
 public:
  explicit Collector(SvgDocument& document) : document_(document) {
    find_named(document.root(), named_);
  }

  void visit(xmlNode* node, Context context) {
    const std::string_view name = svg_name(node);
    const bool is_definition = contains(definitions, name) && !is_opacity_mask(node);
    const bool is_container = is_definition || contains(containers, name);
    if (!is_container && !contains(paintables, name)) return;
    if (is_definition) {
      // What a <use> shows inherits from there.
      if (name == "defs" || name == "symbol") context.fill = context.stroke = nullptr;
      context.shown = false;
    }
    if (!context.shown) context.shown = named_.contains(attribute(node, "id").value_or(""));
    if (attribute(node, "kept-for", gradmesh_namespace)) context.kept = node;
    if (is_mesh_group(node)) {
      if (context.shown) add(node, group_role(node), nullptr, context.kept);
      return;
    }
    update(node, "fill", context.fill);
    update(node, "stroke", context.stroke);
    if (is_container) {
      for (xmlNode* child : child_elements(node)) visit(child, context);
    } else if (context.shown) {
      for (const auto& [role, gradient] :
           {std::pair(PaintRole::fill, context.fill), std::pair(PaintRole::stroke, context.stroke)})
        if (gradient && can_paint(node, role)) add(node, role, gradient, context.kept);
    }
  }

  std::vector<MeshObject> objects;

 private:
  void update(const xmlNode* node, std::string_view property, xmlNode*& gradient) const {
    const auto paint = document_.styles().declared(node, property);
    if (!paint || lower(*paint) == "inherit") return;
    gradient = referenced_mesh(document_, *paint);
  }

  void add(xmlNode* node, PaintRole role, xmlNode* gradient, const xmlNode* kept) {
    std::string id = object_id(node);
    if (id.empty()) id = document_.give_id(whole_object(node), std::string(svg_name(node)));
    objects.push_back({node, std::move(id), role, gradient, kept});
  }

  SvgDocument& document_;
  std::set<std::string> named_;
};

}  // namespace

bool hands_paint_on(const xmlNode* node) { return contains(containers, svg_name(node)); }

bool can_paint(const xmlNode* node, PaintRole role) {
  const std::string_view name = svg_name(node);
  return contains(paintables, name) && (role == PaintRole::stroke || name != "line");
}

std::optional<std::string> referenced_id(std::string_view paint) {
  if (!lower(paint.substr(0, 4)).starts_with("url(")) return std::nullopt;
  const std::size_t close = paint.find(')');
  if (close == paint.npos) return std::nullopt;
  std::string_view target = trimmed(paint.substr(4, close - 4));
  if (target.size() >= 2 && (target.front() == '"' || target.front() == '\'') &&
      target.back() == target.front())
    target = trimmed(target.substr(1, target.size() - 2));
  if (!target.starts_with('#')) return std::nullopt;
  return std::string(target.substr(1));
}

std::string fallback_color(std::string_view paint) {
  const std::size_t close = paint.find(')');
  return close == paint.npos ? "" : std::string(trimmed(paint.substr(close + 1)));
}

xmlNode* whole_object(xmlNode* node) {
  if (is_mesh_group(node))
    for (xmlNode* outer = parent_element(node);
         outer && attribute(outer, "outer", gradmesh_namespace); outer = parent_element(outer))
      node = outer;
  return node;
}

std::string object_id(xmlNode* node) { return attribute(whole_object(node), "id").value_or(""); }

xmlNode* referenced_mesh(const SvgDocument& document, std::string_view paint) {
  const auto id = referenced_id(paint);
  xmlNode* found = id ? document.find(*id) : nullptr;
  return found && is_mesh_gradient(found) ? found : nullptr;
}

std::vector<MeshObject> mesh_objects(SvgDocument& document) {
  Collector collector(document);
  collector.visit(document.root(), {});
  return std::move(collector.objects);
}

Affine to_document(const MeshObject& object) {
  Affine product;
  for (const xmlNode* node = object.node; node; node = parent_element(node))
    if (const auto text = attribute(node, "transform")) {
      const auto transform = parse_transform(*text);
      if (!transform) fail(node, Message("its transform {0} is malformed", excerpt(*text)));
      product = *transform * product;
    }
  return product;
}

}  // namespace gradmesh
