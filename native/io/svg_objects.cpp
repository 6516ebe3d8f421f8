#include "io/svg_objects.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "io/svg_group.h"
#include "io/svg_mesh_names.h"
#include "io/svg_scanner.h"
#include "io/svg_transform.h"
#include "io/xml_node.h"

namespace gradmesh {
namespace {

constexpr std::array<std::string_view, 4> containers{"svg", "g", "a", "switch"};
constexpr std::array<std::string_view, 8> paintables{"path", "rect",     "circle",  "ellipse",
                                                     "line", "polyline", "polygon", "text"};

bool contains(const auto& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// What is in force where an element stands.
struct Context {
  /// The mesh gradients for fill and stroke; null where the paint is anything else.
  xmlNode* fill = nullptr;
  xmlNode* stroke = nullptr;
  /// MeshObject::kept.
  const xmlNode* kept = nullptr;
};

class Collector {
 public:
  explicit Collector(SvgDocument& document) : document_(document) {}

  void visit(xmlNode* node, Context context) {
    const std::string_view name = svg_name(node);
    const bool is_container = contains(containers, name);
    if (!is_container && !contains(paintables, name)) return;
    if (attribute(node, "kept-for", gradmesh_namespace)) context.kept = node;
    if (is_mesh_group(node)) return add(node, group_role(node), nullptr, context.kept);
    update(node, "fill", context.fill);
    update(node, "stroke", context.stroke);
    if (is_container) {
      for (xmlNode* child : child_elements(node)) visit(child, context);
    } else {
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
};

}  // namespace

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
