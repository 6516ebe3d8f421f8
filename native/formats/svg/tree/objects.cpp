#include "formats/svg/tree/objects.h"

#include <algorithm>
#include <array>
#include <map>
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

constexpr std::array<std::string_view, 4> text_elements{"tspan", "textPath", "tref", "a"};

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
  return contains(words, value) || value.starts_with("url") || parse_translucent_color(value);
}

/// The properties in force at an element.
struct Context {
  /// The mesh gradients for fill and stroke; null where the paint is anything else.
  xmlNode* fill = nullptr;
  xmlNode* stroke = nullptr;
  /// The hidden original around the element, as in MeshObject::kept.
  const xmlNode* kept = nullptr;
  /// The opacities of both, as they are written.
  std::string fill_opacity = "1", stroke_opacity = "1";
  /// True if the element is painted; false if it is inside a definition that nothing names.
  bool shown = true;

  xmlNode*& gradient(PaintRole role) { return role == PaintRole::fill ? fill : stroke; }
  std::string& opacity(PaintRole role) {
    return role == PaintRole::fill ? fill_opacity : stroke_opacity;
  }
};

const char* opacity_name(PaintRole role) {
  return role == PaintRole::fill ? "fill-opacity" : "stroke-opacity";
}

bool is_inside(const xmlNode* node, const xmlNode* ancestor) {
  while (node && node != ancestor) node = parent_element(node);
  return node != nullptr;
}

/// Returns true if there are letters in the element itself.
bool has_letters(const xmlNode* node) {
  for (const xmlNode* child = node->children; child; child = child->next)
    if (child->type != XML_ELEMENT_NODE && child->type != XML_COMMENT_NODE &&
        child->type != XML_PI_NODE && !trimmed(view(child->content)).empty())
      return true;
  return false;
}

class Collector {
 public:
  explicit Collector(SvgTree& tree) : tree_(tree), named_(named_ids(tree)) {
    for (const xmlNode* node : elements_from(tree.root()))
      if (svg_name(node) == "use") clones_.emplace(shown_by(node), node);
  }

  void visit(xmlNode* node, Context context) {
    const std::string_view name = svg_name(node);
    const bool is_definition = contains(definitions, name) && !is_opacity_mask(node);
    const bool is_container = is_definition || contains(containers, name);
    if (name == "use" || name == "flowRoot") return add_left_alone(node, context);
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
    update(node, context);
    if (is_container) {
      for (xmlNode* child : child_elements(node)) visit(child, context);
    } else if (context.shown) {
      auto parts = name == "text" ? text_parts(node, context) : std::vector{context};
      for (const PaintRole role : {PaintRole::fill, PaintRole::stroke})
        if (can_paint(node, role)) add_painted(node, role, parts);
    }
  }

  std::vector<MeshObject> objects;

 private:
  void update(const xmlNode* node, Context& context) const {
    const auto declared = [&](const char* property, StyleSheet::Accepts accepts) {
      auto value = tree_.styles().declared(node, property, accepts);
      return value == "inherit" ? std::nullopt : value;
    };
    for (const PaintRole role : {PaintRole::fill, PaintRole::stroke})
      if (const auto paint = declared(paint_name(role), is_readable_paint))
        context.gradient(role) = referenced_mesh(tree_, paint);
    for (const PaintRole role : {PaintRole::fill, PaintRole::stroke})
      if (const auto value = declared(opacity_name(role), nullptr)) context.opacity(role) = *value;
  }

  /// Returns what is in force at the parts of a text that have letters, at least one.
  std::vector<Context> text_parts(const xmlNode* text, const Context& at_text) const {
    std::vector<Context> parts;
    const auto visit_part = [&](const auto& self, const xmlNode* part, Context context) -> void {
      if (part != text) update(part, context);
      if (has_letters(part)) parts.push_back(context);
      for (const xmlNode* child : child_elements(part))
        if (contains(text_elements, svg_name(child))) self(self, child, context);
    };
    visit_part(visit_part, text, at_text);
    if (parts.empty()) parts.push_back(at_text);
    return parts;
  }

  /// Adds an object if one of its parts, the whole of a shape, has a mesh.
  void add_painted(xmlNode* node, PaintRole role, std::vector<Context>& parts) {
    const auto with_mesh =
        std::ranges::find_if(parts, [&](Context& part) { return part.gradient(role) != nullptr; });
    if (with_mesh == parts.end()) return;
    const bool is_mixed = std::ranges::any_of(parts, [&](Context& part) {
      return part.gradient(role) != with_mesh->gradient(role) ||
             part.opacity(role) != with_mesh->opacity(role);
    });
    add(node, role, with_mesh->gradient(role), with_mesh->kept,
        is_mixed                        ? LeftAlone::mixed
        : is_cloned_without(node, role) ? LeftAlone::cloned
                                        : LeftAlone::no);
  }

  /// Returns true if the object has its paint from an element around it, and a clone outside of
  /// that shows the object, which has another paint there.
  bool is_cloned_without(const xmlNode* node, PaintRole role) const {
    const xmlNode* lender = node;
    while (lender && !declares(lender, role)) lender = parent_element(lender);
    for (const xmlNode* shown = node; shown && shown != lender; shown = parent_element(shown)) {
      const auto [first, last] = clones_.equal_range(shown);
      if (std::any_of(first, last, [&](const auto& c) { return !is_inside(c.second, lender); }))
        return true;
    }
    return false;
  }

  bool declares(const xmlNode* node, PaintRole role) const {
    const auto paint = tree_.styles().declared(node, paint_name(role), is_readable_paint);
    return paint.value_or("inherit") != "inherit";
  }

  /// Returns what a <use> shows; null if it leads nowhere.
  const xmlNode* shown_by(const xmlNode* use) const {
    return tree_.find(linked_id(href(use), tree_.name()).value_or(""));
  }

  void add_left_alone(xmlNode* node, Context context) {
    update(node, context);
    if (!context.shown) context.shown = named_.contains(attribute(node, "id").value_or(""));
    if (!context.shown) return;
    const bool is_clone = svg_name(node) == "use";
    for (const PaintRole role : {PaintRole::fill, PaintRole::stroke})
      if (xmlNode* gradient = context.gradient(role); gradient && (!is_clone || lends(node, role)))
        add(node, role, gradient, context.kept, is_clone ? LeftAlone::clone : LeftAlone::flowed);
  }

  /// Returns true if a clone shows a shape or text that has no such paint of its own, or more
  /// elements than are looked at: clones of clones may show any number.
  bool lends(const xmlNode* clone, PaintRole role) const {
    constexpr std::size_t most = 1000;
    std::set<const xmlNode*> seen;
    std::vector<const xmlNode*> open{shown_by(clone)};
    while (!open.empty()) {
      const xmlNode* const node = open.back();
      open.pop_back();
      if (!node || !seen.insert(node).second || declares(node, role)) continue;
      if (can_paint(node, role) || seen.size() > most) return true;
      const std::string_view name = svg_name(node);
      if (name == "use") open.push_back(shown_by(node));
      if (contains(containers, name) || name == "symbol")
        for (const xmlNode* child : child_elements(node)) open.push_back(child);
    }
    return false;
  }

  void add(xmlNode* node, PaintRole role, xmlNode* gradient, const xmlNode* kept,
           LeftAlone left_alone = LeftAlone::no) {
    std::string id = object_id(node);
    if (id.empty()) id = tree_.give_id(whole_object(node), std::string(svg_name(node)));
    objects.push_back({node, std::move(id), role, gradient, kept, left_alone});
  }

  SvgTree& tree_;
  const std::set<std::string> named_;
  /// Every <use>, by what it shows.
  std::multimap<const xmlNode*, const xmlNode*> clones_;
};

/// Returns the places of the objects that are, or are inside of, the element.
std::vector<std::size_t> objects_in(const xmlNode* element,
                                    const std::vector<MeshObject>& objects) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const auto& [node, id, role, gradient, kept, left_alone] = objects[i];
    if (is_inside(node, element) && (!kept || is_inside(element, kept))) places.push_back(i);
  }
  return places;
}

/// Returns why an element is no mesh and holds none.
Message why_unpainted(const xmlNode* node) {
  for (const xmlNode* outer = node; outer; outer = parent_element(outer))
    if (svg_name(outer) == "clipPath") return Message("it is in a clipPath, which paints nothing");
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

void check_can_change(const MeshObject& object) {
  switch (object.left_alone) {
    case LeftAlone::no:
      return;
    case LeftAlone::clone:
      fail(object,
           Message("it is a clone that lends its mesh to what it shows; to change the mesh, "
                   "unlink the clone"));
    case LeftAlone::cloned:
      fail(object,
           Message("its mesh belongs to a group around it, and a clone outside of the group is "
                   "painted without; to change the mesh, give it to the object itself"));
    case LeftAlone::flowed:
      fail(object, Message("it is flowed text; to change its mesh, convert it to text"));
    case LeftAlone::mixed:
      fail(object, Message("parts of the text are painted in other ways; to change the mesh, give "
                           "all of it one paint"));
  }
}

}  // namespace gradmesh
