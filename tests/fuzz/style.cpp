#include <set>
#include <string>

#include "formats/svg/tree/svg_tree.h"
#include "formats/svg/values/css_text.h"
#include "formats/svg/values/moved_css.h"
#include "formats/svg/values/reference.h"
#include "formats/svg/values/selector.h"
#include "formats/svg/values/style.h"
#include "formats/svg/xml/node.h"
#include "formats/text/scanner.h"
#include "target.h"

namespace gradmesh::fuzz {
namespace {

void set_text(xmlNode* node, const std::string& text) {
  xmlNodeSetContent(node, nullptr);
  xmlNodeAddContentLen(node, reinterpret_cast<const xmlChar*>(text.data()), int(text.size()));
}

/// Declarations are written in another order than they were read in, and mean the same.
void check_order(const Declarations& declarations) {
  std::string reversed;
  for (const auto& [property, value] : declarations)
    reversed = property + ":" + value + ";" + reversed;
  require(parse_declarations(reversed) == declarations, "the order does not count");
}

}  // namespace

/// By its key a selector is found for an element that it matches.
void check_selectors(const std::string& text, const xmlNode* path) {
  const std::set<std::string> keys{"*", "path", ".a", "#p"};
  for (const Selector& selector : parse_selectors(text))
    require(!selector.matches(path) || keys.contains(selector.key()), "the key is the element's");
}

/// A style sheet that goes into another folder and back goes there again as it did.
void check_moves(const std::string& text) {
  const FolderMove away{"/pages/drawing.svg", "/pages/made/of"},
      back{"/pages/made/of/it.svg", "/pages"};
  const auto there = moved_css(text, away);
  if (!there) return;
  const std::string home = moved_css(*there, back).value_or(*there);
  require(moved_css(home, away).value_or(home) == *there, "there and back leads to the same files");
}

/// The text as a style sheet, and as the style of one element.
void check(std::string_view bytes) {
  const std::string text(bytes);
  static const SvgTree document = SvgTree::parse(
      "<svg><style/><g class=\"a b\"><path id=\"p\" class=\"a\" fill=\"red\"/></g></svg>",
      input_name);
  xmlNode* const style = child_elements(document.root(), "style").front();
  xmlNode* const group = child_elements(document.root(), "g").front();
  xmlNode* const path = child_elements(group).front();
  set_text(style, text);
  set_attribute(group, "style", text);

  check_order(parse_declarations(text));
  const StyleSheet styles(document.root());
  for (const auto& [property, value] : parse_declarations(text)) {
    require(property == trimmed(property), "names have no blanks");
    require(styles.declared(group, property) == without_important(value) ||
                styles.outranks_style(group, property) || has_broken_url(value) ||
                text.find('\0') != text.npos,
            "an element's own style wins");
    const auto id = referenced_id(value, input_name);
    require(!id || value.find('#') != value.npos, "a reference has a #");
    fallback_color(value);
  }
  check_selectors(text, path);
  check_moves(text);
  require(styles.declared(path, "fill").has_value(), "an attribute counts");
  styles.inherited(path, "fill");
  styles.inherited(path, "stop-color");
}

}  // namespace gradmesh::fuzz
