#include "formats/svg/tree/paint.h"

#include <algorithm>
#include <array>

#include "formats/svg/tree/own.h"
#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

using Names = std::initializer_list<std::string_view>;

bool among(Names names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_geometry(std::string_view name) {
  return among({"d",      "x",  "y",  "width",  "height",     "rx",           "ry",
                "cx",     "cy", "r",  "x1",     "y1",         "x2",           "y2",
                "points", "dx", "dy", "rotate", "textLength", "lengthAdjust", "pathLength"},
               name);
}

bool is_paint(std::string_view name) {
  return name.starts_with("fill") || name.starts_with("stroke") || name.starts_with("marker") ||
         among({"paint-order", "vector-effect"}, name);
}

bool is_font(std::string_view name) {
  return name.starts_with("font") || name.starts_with("text") || name.starts_with("letter") ||
         name.starts_with("word") || name.starts_with("-inkscape-font") ||
         among({"line-height", "white-space", "writing-mode", "direction", "baseline-shift",
                "dominant-baseline", "shape-inside"},
               name);
}

/// Properties that CSS does not inherit and that act on the object as a whole, with the values that
/// turn them off.
constexpr std::array<std::pair<const char*, const char*>, 7> effects{{{"opacity", "1"},
                                                                      {"filter", "none"},
                                                                      {"clip-path", "none"},
                                                                      {"mask", "none"},
                                                                      {"mix-blend-mode", "normal"},
                                                                      {"isolation", "auto"},
                                                                      {"display", "inline"}}};

/// Copies an attribute, in a namespace that is declared at `to`, as the attribute's own may be
/// declared by its own element only.
void copy_attribute(const xmlAttr* a, xmlNode* to) {
  const std::string name(view(a->name)), value = text_of(a->children, a->parent);
  if (a->ns)
    set_attribute(to, name.c_str(), value, view(a->ns->href),
                  std::string(view(a->ns->prefix)).c_str());
  else
    set_attribute(to, name.c_str(), value);
}

Declarations style_of(const xmlNode* node) {
  return parse_declarations(attribute(node, "style").value_or(""));
}

void write_style(xmlNode* node, const Declarations& style) {
  std::string text;
  for (const auto& [name, value] : style)
    text.append(text.empty() ? "" : ";").append(name).append(":").append(value);
  if (text.empty()) {
    remove_attribute(node, "style");
  } else {
    set_attribute(node, "style", text);
  }
}

/// Takes the paints of the parts of a text away, which are those of the text then.
void remove_paints_below(xmlNode* text) {
  for (xmlNode* part : elements_from(text)) {
    if (part == text) continue;
    for (const char* paint : {"fill", "stroke"}) {
      take_style(part, paint);
      remove_attribute(part, paint);
    }
  }
}

/// Gives the title and the description of an element to another one.
void move_description(xmlNode* from, xmlNode* to) {
  for (xmlNode* child : child_elements(from))
    if (among({"title", "desc"}, svg_name(child))) {
      xmlUnlinkNode(child);
      xmlAddChild(to, child);
    }
}

}  // namespace

std::string paint_by(const std::string& id, const std::string& fallback) {
  return "url(#" + id + ")" + (fallback.empty() ? "" : " " + fallback);
}

void set_style(const StyleSheet& styles, xmlNode* node, const std::string& property,
               const std::string& value) {
  Declarations style = style_of(node);
  style[property] = value;
  if (styles.outranks_style(node, property)) style[property] += important_mark;
  write_style(node, style);
  remove_attribute(node, property.c_str());
}

void set_paint(const StyleSheet& styles, xmlNode* node, const std::string& property,
               const std::string& value) {
  set_style(styles, node, property, value);
  if (svg_name(node) != "text") return;
  for (xmlNode* part : elements_from(node))
    if (part != node && styles.declared(part, property)) set_style(styles, part, property, value);
}

void hand_back_paint(const StyleSheet& styles, const xmlNode* node, const std::string& property,
                     const std::string& value) {
  const auto declares = [&](const xmlNode* element) {
    return styles.declared(element, property).value_or("inherit") != "inherit";
  };
  xmlNode* lender = parent_element(node);
  while (lender && !declares(lender)) lender = parent_element(lender);
  const auto takes = [&](const auto& self, const xmlNode* element) -> bool {
    if (declares(element)) return false;
    const auto children = child_elements(element);
    const bool is_plain = among({"g", "a", "switch", "svg"}, svg_name(element));
    if (!is_plain) return !among({"defs", "title", "desc", "metadata", "style"}, svg_name(element));
    return std::ranges::any_of(children, [&](const xmlNode* child) { return self(self, child); });
  };
  if (!lender) return;
  const auto children = child_elements(lender);
  if (std::ranges::none_of(children, [&](const xmlNode* child) { return takes(takes, child); }))
    set_style(styles, lender, property, value);
}

std::string take_style(xmlNode* node, const std::string& property) {
  Declarations style = style_of(node);
  const auto found = style.extract(property);
  if (!found) return "";
  write_style(node, style);
  return without_important(found.mapped());
}

void move_group_attributes(const StyleSheet& styles, xmlNode* shape, xmlNode* group) {
  Declarations of_group, of_shape;
  for (const auto& [name, value] : style_of(shape))
    (is_paint(name) || is_font(name) ? of_shape : of_group)[name] = value;
  // Rules may follow the shape's class or name, so what they say is written out.
  for (const auto& [name, off] : effects)
    if (const auto value = styles.declared(shape, name)) of_group[name] = *value;

  for (xmlAttr* a : attributes(shape)) {
    const std::string_view name = view(a->name);
    const bool stays = !a->ns && (is_geometry(name) || is_paint(name) || is_font(name) ||
                                  among({"class", "style", "id"}, name));
    if (stays) continue;
    const bool describes_shape =
        a->ns && (view(a->ns->prefix) == "sodipodi" ||
                  among({"original-d", "path-effect", "connector-curvature"}, name));
    if (!describes_shape) copy_attribute(a, group);
    xmlRemoveProp(a);
  }
  for (const auto& [name, off] : effects) remove_attribute(group, name);
  // Inkscape knows clips and masks as attributes only.
  for (const char* name : {"clip-path", "mask"})
    if (const auto found = of_group.extract(name); found && found.mapped() != "none")
      set_attribute(group, name, found.mapped());
  write_style(group, of_group);
  write_style(shape, of_shape);
  for (const auto& [name, off] : effects)
    if (!of_group.contains(name) && styles.declared(group, name) && !attribute(group, name))
      set_style(styles, group, name, off);
  turn_off_effects(styles, shape);
  move_description(shape, group);
}

Declarations said_by_rules(const StyleSheet& styles, const xmlNode* node) {
  Declarations said;
  for (const std::string& property : styles.properties([](std::string_view) { return true; }))
    if (const auto value = styles.declared(node, property);
        value && styles.rules_say(node, property))
      said[property] = *value;
  return said;
}

void keep_said(const StyleSheet& styles, const Declarations& said, xmlNode* node) {
  for (const auto& [property, value] : said)
    if (styles.declared(node, property) != value) set_style(styles, node, property, value);
  const Declarations own = style_of(node);
  for (const auto& [property, value] : said_by_rules(styles, node)) {
    if (said.contains(property) || own.contains(property)) continue;
    const auto effect = std::ranges::find(effects, property, [](const auto& e) { return e.first; });
    const std::string otherwise = effect == effects.end() ? "inherit" : effect->second;
    set_style(styles, node, property, attribute(node, property.c_str()).value_or(otherwise));
  }
}

bool is_effect(std::string_view property) {
  return std::ranges::any_of(effects, [&](const auto& effect) { return effect.first == property; });
}

void turn_off_effects(const StyleSheet& styles, xmlNode* node) {
  for (const auto& [name, off] : effects)
    if (styles.declared(node, name)) set_style(styles, node, name, off);
}

void return_group_attributes(const StyleSheet& styles, xmlNode* group, xmlNode* shape) {
  for (const auto& [name, value] : style_of(group)) set_style(styles, shape, name, value);
  for (xmlAttr* a : attributes(group)) {
    const std::string_view name = view(a->name);
    if (!a->ns && among({"id", "style"}, name)) continue;
    if (a->ns && view(a->ns->href) == gradmesh_namespace) continue;
    xmlSetNsProp(shape, a->ns, a->name,
                 reinterpret_cast<const xmlChar*>(text_of(a->children, group).c_str()));
  }
  move_description(group, shape);
}

bool has_effects(const StyleSheet& styles, const xmlNode* group) {
  return std::ranges::any_of(std::array{"filter", "clip-path", "mask"}, [&](const char* name) {
    return styles.declared(group, name).value_or("none") != "none";
  });
}

void keep_only_paint(const StyleSheet& styles, xmlNode* shape, const std::string& paint) {
  if (const auto value = styles.inherited(shape, paint)) set_style(styles, shape, paint, *value);
  set_paint(styles, shape, paint == "fill" ? "stroke" : "fill", "none");
}

xmlNode* geometry_copy(const StyleSheet& styles, const xmlNode* shape, xmlNode* parent) {
  xmlNode* copy = add_copy(parent, shape);
  const bool text = svg_name(shape) == "text";
  for (xmlAttr* a : attributes(copy)) {
    const std::string_view name = view(a->name);
    const bool stays = !a->ns && (is_geometry(name) || (text && is_font(name)));
    const bool space = text && a->ns && view(a->ns->prefix) == "xml";
    if (!stays && !space) xmlRemoveProp(a);
  }
  if (text) {
    Declarations fonts;
    for (const auto& [name, value] : style_of(shape))
      if (is_font(name)) fonts[name] = value;
    for (const char* name :
         {"font-family", "font-size", "font-weight", "font-style", "text-anchor"})
      if (const auto value = styles.inherited(shape, name)) fonts[name] = *value;
    write_style(copy, fonts);
    remove_paints_below(copy);
  }
  turn_off_effects(styles, copy);
  return copy;
}

void paint_stroke_white(const StyleSheet& styles, const xmlNode* shape, xmlNode* copy) {
  for (const char* name :
       {"stroke-width", "stroke-linecap", "stroke-linejoin", "stroke-miterlimit",
        "stroke-dasharray", "stroke-dashoffset", "stroke-opacity", "vector-effect"})
    if (const auto value = styles.inherited(shape, name)) set_style(styles, copy, name, *value);
  set_style(styles, copy, "fill", "none");
  set_style(styles, copy, "stroke", "#ffffff");
}

void set_clip_rule(const StyleSheet& styles, const xmlNode* shape, xmlNode* copy) {
  if (const auto rule = styles.inherited(shape, "fill-rule"))
    set_style(styles, copy, "clip-rule", *rule);
}

}  // namespace gradmesh
