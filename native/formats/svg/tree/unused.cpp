#include "formats/svg/tree/unused.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include "formats/svg/values/mesh_names.h"
#include "formats/svg/values/reference.h"
#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

/// Returns true if a letter of a text may belong to an id that the text names.
bool is_of_id(char letter) {
  const auto c = static_cast<unsigned char>(letter);
  return std::isalnum(c) || c == '-' || c == '_' || c == '.' || c == ':' || c >= 0x80;
}

/// Returns true if `text` holds `#id`, and not just an id that begins with it.
bool holds_id(std::string_view text, const std::string& id) {
  const std::string wanted = "#" + id;
  for (std::size_t at = text.find(wanted); at != text.npos; at = text.find(wanted, at + 1)) {
    const std::size_t end = at + wanted.size();
    if (end == text.size() || !is_of_id(text[end])) return true;
  }
  return false;
}

/// Returns true if `text` names `#id`, as it is or with escapes.
bool names_id(std::string_view text, const std::string& id) {
  return holds_id(text, id) || (text.find('%') != text.npos && holds_id(percent_decoded(text), id));
}

/// Returns true if a style sheet names the element with this id, and not just selects it.
bool refers_to(const std::string& css, const std::string& id) {
  for (std::size_t at = css.find("url("); at != css.npos; at = css.find("url(", at + 1))
    if (names_id(css.substr(at, css.find(')', at) - at + 1), id)) return true;
  return false;
}

/// Returns rules in which the paints that name this id are replaced by their colours.
std::string without_paint(std::string css, const std::string& id, const std::string& file) {
  for (std::size_t at = 0; (at = css.find("url(", at)) != css.npos;) {
    const std::size_t end = std::min(css.find_first_of(";}", at), css.size());
    const std::string_view paint = std::string_view(css).substr(at, end - at);
    if (referenced_id(paint, file) != id) {
      ++at;
      continue;
    }
    const std::string fallback = fallback_color(paint);
    css.replace(at, end - at,
                fallback.empty() || fallback.front() == '!' ? "none" + fallback : fallback);
  }
  return css;
}

void replace_paints_in_rules(SvgTree& tree, const std::string& id) {
  for (const xmlNode* node : elements_from(tree.root())) {
    if (svg_name(node) != "style") continue;
    for (xmlNode* text = node->children; text; text = text->next) {
      if (text->type != XML_TEXT_NODE && text->type != XML_CDATA_SECTION_NODE) continue;
      const std::string css(view(text->content));
      const std::string changed = without_paint(css, id, tree.name());
      if (changed != css)
        xmlNodeSetContent(text, reinterpret_cast<const xmlChar*>(changed.c_str()));
    }
  }
}

/// Returns the ids of letters of ids that attributes name, or rules that some element follows.
std::set<std::string> used_ids(const SvgTree& tree) {
  const StyleSheet& styles = tree.styles();
  std::set<std::string> ids;
  const auto add = [&](std::string_view text) {
    for (std::size_t at = text.find('#'); at != text.npos; at = text.find('#', at + 1)) {
      const auto end =
          std::find_if_not(text.begin() + std::ptrdiff_t(at) + 1, text.end(), is_of_id);
      ids.emplace(text.begin() + std::ptrdiff_t(at) + 1, end);
    }
  };
  const auto add_decoded = [&](const std::string& text) {
    add(text);
    if (text.find('%') != text.npos) add(percent_decoded(text));
  };
  const std::vector<std::string> properties =
      styles.properties([](std::string_view value) { return value.find('#') != value.npos; });
  for (const xmlNode* node : elements_from(tree.root())) {
    for (const xmlAttr* a : attributes(node)) add_decoded(text_of(a->children, node));
    for (const std::string& property : properties)
      add_decoded(styles.declared(node, property).value_or(""));
    // What is not read here may be by another version of Inkscape.
    if (svg_name(node) == "style") add_decoded(text_of(node->children, node));
  }
  return ids;
}

}  // namespace

bool is_used(const SvgTree& tree, const std::string& id, const std::set<const xmlNode*>& except) {
  const StyleSheet& styles = tree.styles();
  const std::vector<std::string> properties =
      styles.properties([&](std::string_view value) { return names_id(value, id); });
  return std::ranges::any_of(elements_from(tree.root()), [&](const xmlNode* node) {
    const auto names = [&](const xmlAttr* a) { return names_id(text_of(a->children, node), id); };
    const auto follows = [&](const std::string& property) {
      return names_id(styles.declared(node, property).value_or(""), id);
    };
    if (except.contains(node)) return false;
    // What is not read here may be by another version of Inkscape.
    const bool is_unread = properties.empty() && svg_name(node) == "style" &&
                           refers_to(text_of(node->children, node), id);
    return is_unread || std::ranges::any_of(attributes(node), names) ||
           std::ranges::any_of(properties, follows);
  });
}

bool is_cloned(const SvgTree& tree, const xmlNode* node) {
  std::set<std::string> around;
  for (; node; node = parent_element(node)) around.insert(attribute(node, "id").value_or(""));
  return std::ranges::any_of(elements_from(tree.root()), [&](const xmlNode* use) {
    const auto shown = svg_name(use) == "use" ? linked_id(href(use), tree.name()) : std::nullopt;
    return shown && around.contains(*shown);
  });
}

void remove_named(SvgTree& tree, xmlNode* node) {
  replace_paints_in_rules(tree, attribute(node, "id").value_or(""));
  remove_node(node);
}

void remove_if_unused(SvgTree& tree, const std::string& id) {
  xmlNode* node = id.empty() ? nullptr : tree.find(id);
  if (!node || is_used(tree, id)) return;
  const std::string target = href(node);
  remove_named(tree, node);
  const std::string next = linked_id(target, tree.name()).value_or("");
  const xmlNode* const linked = tree.find(next);
  if (linked && is_mesh_gradient(linked)) remove_if_unused(tree, next);
}

void remove_with_clips(SvgTree& tree, const std::vector<xmlNode*>& nodes) {
  std::set<std::string> named;
  for (xmlNode* const node : nodes) {
    for (const xmlNode* element : elements_from(node))
      for (const char* property : {"clip-path", "mask"}) {
        const auto value = tree.styles().declared(element, property);
        const auto id = value ? referenced_id(*value, tree.name()) : std::nullopt;
        if (id) named.insert(*id);
      }
    remove_node(node);
  }
  std::vector<xmlNode*> unused;
  const std::set<std::string> used = used_ids(tree);
  for (const std::string& id : named)
    if (xmlNode* const limit = tree.find(id); limit && !used.contains(id))
      // What has stranger letters in it is no id to that.
      if (std::ranges::all_of(id, is_of_id) || !is_used(tree, id)) unused.push_back(limit);
  if (!unused.empty()) remove_with_clips(tree, unused);
}

}  // namespace gradmesh
