#include "formats/svg/tree/objects.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>

#include "base/error.h"
#include "formats/svg/tree/own.h"
#include "formats/svg/values/color.h"
#include "formats/svg/values/length.h"
#include "formats/svg/values/mesh_names.h"
#include "formats/svg/values/reference.h"
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
      const std::string_view id = rest.substr(0, rest.find_first_of(")'\"; \t\r\n"));
      ids.emplace(id);
      ids.insert(percent_decoded(id));
    }
  }
}

/// Returns the ids that the attributes and rules of a document name.
std::set<std::string> named_ids(const SvgTree& tree) {
  std::set<std::string> ids;
  for (const xmlNode* node : elements_from(tree.root())) {
    for (const xmlAttr* a : attributes(node)) find_named_in(a->children, ids);
    if (svg_name(node) == "style") find_named_in(node->children, ids);
  }
  return ids;
}

/// Returns the role of a group of blocks. Throws InputError if `version` is not 1.
PaintRole group_role(const xmlNode* group) {
  if (own_attribute(group, "version") != "1")
    fail(group, Message("it was written by a newer gradmesh than this one"));
  return own_attribute(group, "role") == "stroke" ? PaintRole::stroke : PaintRole::fill;
}

/// Returns true for a paint that Inkscape can read; any other is as if it were not there.
bool is_readable_paint(std::string_view value) {
  constexpr std::array<std::string_view, 5> words{"none", "inherit", "currentColor", "context-fill",
                                                  "context-stroke"};
  return contains(words, value) || value.starts_with("url") || parse_color(value);
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
  explicit Collector(SvgTree& tree) : tree_(tree), named_(named_ids(tree)) {}

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
    if (own_attribute(node, "kept-for")) context.kept = node;
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
    const auto paint = tree_.styles().declared(node, property, is_readable_paint);
    if (paint && *paint != "inherit") gradient = referenced_mesh(tree_, paint);
  }

  void add(xmlNode* node, PaintRole role, xmlNode* gradient, const xmlNode* kept) {
    std::string id = object_id(node);
    if (id.empty()) id = tree_.give_id(whole_object(node), std::string(svg_name(node)));
    objects.push_back({node, std::move(id), role, gradient, kept});
  }

  SvgTree& tree_;
  const std::set<std::string> named_;
};

bool is_inside(const xmlNode* node, const xmlNode* ancestor) {
  while (node && node != ancestor) node = parent_element(node);
  return node != nullptr;
}

/// Returns the places of the objects that are, or are inside of, the element.
std::vector<std::size_t> objects_in(const xmlNode* element,
                                    const std::vector<MeshObject>& objects) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const auto& [node, id, role, gradient, kept] = objects[i];
    if (is_inside(node, element) && (!kept || is_inside(element, kept))) places.push_back(i);
  }
  return places;
}

/// Returns why an element is no mesh and holds none.
Message why_unpainted(const xmlNode* node) {
  for (const xmlNode* outer = node; outer; outer = parent_element(outer))
    if (svg_name(outer) == "clipPath")
      return Message("it is in a clipPath, of which nothing is painted");
  return Message("it is not painted by a mesh gradient");
}

}  // namespace

const char* paint_name(PaintRole role) { return role == PaintRole::fill ? "fill" : "stroke"; }

bool hands_paint_on(const xmlNode* node) { return contains(containers, svg_name(node)); }

bool can_paint(const xmlNode* node, PaintRole role) {
  const std::string_view name = svg_name(node);
  return contains(paintables, name) && (role == PaintRole::stroke || name != "line");
}

xmlNode* whole_object(xmlNode* node) {
  return is_mesh_group(node) ? with_outer(node).back() : node;
}

std::string object_id(xmlNode* node) { return attribute(whole_object(node), "id").value_or(""); }

xmlNode* referenced(const SvgTree& tree, const std::optional<std::string>& value) {
  const auto id = value ? referenced_id(*value, tree.name()) : std::nullopt;
  return id ? tree.find(*id) : nullptr;
}

xmlNode* referenced_mesh(const SvgTree& tree, const std::optional<std::string>& paint) {
  xmlNode* found = referenced(tree, paint);
  return found && is_mesh_gradient(found) ? found : nullptr;
}

xmlNode* opacity_mask(const SvgTree& tree, const xmlNode* group) {
  xmlNode* mask = referenced(tree, attribute(group, "mask"));
  return mask && is_opacity_mask(mask) ? mask : nullptr;
}

std::vector<MeshObject> mesh_objects(SvgTree& tree) {
  Collector collector(tree);
  collector.visit(tree.root(), {});
  return std::move(collector.objects);
}

std::vector<std::size_t> objects_named(const SvgTree& tree, const std::vector<MeshObject>& objects,
                                       const std::string& id) {
  const xmlNode* element = tree.find(id);
  if (!element)
    throw InputError("{0}: there is no object with the id {1}.", tree.name(), excerpt(id));
  auto places = objects_in(element, objects);
  if (places.empty()) fail(element, why_unpainted(element));
  return places;
}

std::vector<std::size_t> objects_shown(const SvgTree& tree,
                                       const std::vector<MeshObject>& objects) {
  auto places = objects_in(tree.root(), objects);
  if (places.empty())
    throw InputError("{0}: no object in this document is painted by a mesh gradient.", tree.name());
  return places;
}

Message describe(const MeshObject& object) { return describe(object.node); }
void fail(const MeshObject& object, const Message& reason) { fail(object.node, reason); }

Affine to_document(const xmlNode* element) {
  Affine product;
  for (const xmlNode* node = element; node; node = parent_element(node))
    if (const auto text = attribute(node, "transform")) {
      const auto transform = parse_transform(*text);
      if (!transform) fail(node, Message("its transform {0} is malformed", excerpt(*text)));
      product = *transform * product;
    }
  return product;
}

Affine to_document(const MeshObject& object) { return to_document(object.node); }

Affine to_page(const SvgTree& tree, const MeshObject& object) {
  return to_pixels(tree.root()) * to_document(object);
}

}  // namespace gradmesh
