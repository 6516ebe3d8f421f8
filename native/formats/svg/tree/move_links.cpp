#include "formats/svg/tree/move_links.h"

#include <algorithm>
#include <array>

#include "formats/svg/values/moved_css.h"
#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

/// Attributes whose values may hold `url(…)`, those of animations included.
constexpr std::array<std::string_view, 17> attributes_with_urls = {
    "by",         "clip-path",  "cursor",       "fill", "filter",       "from",           "marker",
    "marker-end", "marker-mid", "marker-start", "mask", "shape-inside", "shape-subtract", "stroke",
    "style",      "to",         "values"};

using Moved = std::optional<std::string> (*)(std::string_view, const FolderMove&);

bool is_text(const xmlNode* node) {
  return node->type == XML_TEXT_NODE || node->type == XML_CDATA_SECTION_NODE;
}

/// Gives a node that holds a text what the text becomes; returns false if it stays.
bool move_text(xmlNode* node, Moved moved, const FolderMove& move) {
  const auto text = moved(view(node->content), move);
  if (text) xmlNodeSetContent(node, reinterpret_cast<const xmlChar*>(text->c_str()));
  return text.has_value();
}

/// Does so with a list of nodes, in which references to entities stay.
bool move_texts(xmlNode* first, Moved moved, const FolderMove& move) {
  bool is_changed = false;
  for (xmlNode* node = first; node; node = node->next)
    if (is_text(node)) is_changed |= move_text(node, moved, move);
  return is_changed;
}

bool is_href(const xmlAttr* attribute) {
  return view(attribute->name) == "href" &&
         (!attribute->ns || view(attribute->ns->href) == xlink_namespace);
}

bool holds_urls(const xmlAttr* attribute) {
  return !attribute->ns && std::ranges::find(attributes_with_urls, view(attribute->name)) !=
                               attributes_with_urls.end();
}

bool move_attribute(xmlAttr* attribute, const FolderMove& move) {
  if (holds_urls(attribute)) return move_texts(attribute->children, moved_css, move);
  // Of a link in several parts, with entities between them, none is known to be the beginning.
  const xmlNode* const value = attribute->children;
  const bool is_link = is_href(attribute) && svg_name(attribute->parent) != "a";
  return is_link && value && !value->next && move_texts(attribute->children, moved_link, move);
}

bool has_base(const xmlNode* element) {
  return xmlHasNsProp(const_cast<xmlNode*>(element), reinterpret_cast<const xmlChar*>("base"),
                      XML_XML_NAMESPACE) != nullptr;
}

/// Changes the links of an element and of all below it.
bool move_below(xmlNode* element, const FolderMove& move) {
  if (has_base(element)) return false;
  bool is_changed = false;
  const std::string_view name = svg_name(element);
  if (!name.empty())
    for (xmlAttr* attribute : attributes(element)) is_changed |= move_attribute(attribute, move);
  if (name == "style") is_changed |= move_texts(element->children, moved_css, move);
  for (xmlNode* child : child_elements(element)) is_changed |= move_below(child, move);
  return is_changed;
}

/// Returns what the text of `<?xml-stylesheet href="…"?>` becomes.
std::optional<std::string> moved_instruction(std::string_view text, const FolderMove& move) {
  const std::size_t href = text.find("href");
  const std::size_t open = text.find_first_of("\"'", std::min(href, text.size()));
  if (open == text.npos) return std::nullopt;
  const std::size_t close = std::min(text.find(text[open], open + 1), text.size());
  const auto moved = moved_link(text.substr(open + 1, close - open - 1), move);
  if (!moved) return std::nullopt;
  return std::string(text.substr(0, open + 1)) + *moved + std::string(text.substr(close));
}

/// Changes the style sheets that are linked before the outermost element.
bool move_instructions(const xmlDoc* document, const FolderMove& move) {
  bool is_changed = false;
  for (xmlNode* node = document->children; node; node = node->next)
    if (node->type == XML_PI_NODE && view(node->name) == "xml-stylesheet")
      is_changed |= move_text(node, moved_instruction, move);
  return is_changed;
}

}  // namespace

bool move_links(SvgTree& tree, const FolderMove& move) {
  const bool has_sheets = move_instructions(tree.root()->doc, move);
  return move_below(tree.root(), move) || has_sheets;
}

}  // namespace gradmesh
