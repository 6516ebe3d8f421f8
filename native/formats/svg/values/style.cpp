#include "formats/svg/values/style.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "formats/svg/xml/node.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

/// The state of a reader of CSS: inside quotes or parentheses, after a backslash.
class Nesting {
 public:
  bool is_outside() const { return !quote_ && depth_ == 0 && !escaped_; }

  void take(char c) {
    if (escaped_) {
      escaped_ = false;
    } else if (c == '\\') {
      escaped_ = true;
    } else if (quote_) {
      if (c == quote_) quote_ = 0;
    } else if (c == '"' || c == '\'') {
      quote_ = c;
    } else if (c == '(') {
      ++depth_;
    } else if (c == ')') {
      depth_ = std::max(0, depth_ - 1);
    }
  }

  /// Returns the text that closes what is open.
  std::string ending() const {
    return std::string(escaped_ ? "\\" : "") + std::string(quote_ ? 1 : 0, quote_) +
           std::string(std::size_t(depth_), ')');
  }

 private:
  char quote_ = 0;
  int depth_ = 0;
  bool escaped_ = false;
};

/// Returns the position of the next of `ends` in `text` from `start` on that is neither inside
/// quotes nor inside parentheses; the text's size if there is none.
std::size_t find_outside(std::string_view text, std::string_view ends, std::size_t start) {
  Nesting nesting;
  for (std::size_t i = start; i < text.size(); ++i) {
    if (nesting.is_outside() && ends.find(text[i]) != ends.npos) return i;
    nesting.take(text[i]);
  }
  return text.size();
}

/// Returns the text with what CSS adds at its end if quotes or parentheses are left open, so that
/// other declarations may follow it.
std::string closed(std::string_view text) {
  Nesting nesting;
  for (const char c : text) nesting.take(c);
  return std::string(text) + nesting.ending();
}

/// Returns `text` without CSS comments and without the marks that once hid style sheets from old
/// browsers, each of which separates like a blank.
std::string without_comments(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view rest = text.substr(i);
    if (rest.starts_with("/*")) {
      const std::size_t end = rest.find("*/", 2);
      i = end == rest.npos ? text.size() : i + end + 2;
      result += ' ';
    } else if (rest.starts_with("<!--") || rest.starts_with("-->")) {
      i += rest.starts_with("-->") ? 3 : 4;
      result += ' ';
    } else {
      result += text[i++];
    }
  }
  return result;
}

std::string_view without_important(std::string_view value) {
  const std::size_t mark = find_outside(value, "!", 0);
  return trimmed(value.substr(0, mark));
}

/// Returns the position after the block that opens at `text[open]`.
std::size_t block_end(std::string_view text, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); i = find_outside(text, "{}", i + 1)) {
    depth += text[i] == '{' ? 1 : -1;
    if (depth == 0) return i + 1;
  }
  return text.size();
}

bool is_name(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || static_cast<unsigned char>(c) >= 0x80;
  });
}

bool is_simple_selector(std::string_view selector) {
  const bool marked = selector.starts_with('.') || selector.starts_with('#');
  return is_name(selector.substr(marked ? 1 : 0));
}

std::vector<std::string> split_words(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && !is_blank(text[end])) ++end;
    if (end > i) words.emplace_back(text.substr(i, end - i));
    i = end + 1;
  }
  return words;
}

/// Returns all declarations in their order, also of equal names.
std::vector<std::pair<std::string, std::string>> declaration_list(std::string_view text) {
  const std::string clean = without_comments(text);
  const std::string_view view = clean;
  std::vector<std::pair<std::string, std::string>> declarations;
  for (std::size_t start = 0; start < view.size();) {
    const std::size_t end = find_outside(view, ";", start);
    const std::string_view declaration = view.substr(start, end - start);
    const std::size_t colon = declaration.find(':');
    std::string name = lower(trimmed(declaration.substr(0, colon)));
    if (colon != declaration.npos && is_name(name))
      declarations.emplace_back(std::move(name),
                                closed(without_important(declaration.substr(colon + 1))));
    start = end + 1;
  }
  return declarations;
}

}  // namespace

Declarations parse_declarations(std::string_view text) {
  Declarations declarations;
  for (auto& [name, value] : declaration_list(text)) declarations[name] = std::move(value);
  return declarations;
}

StyleSheet::StyleSheet(const xmlNode* root) { read_below(root); }

void StyleSheet::read_below(const xmlNode* node) {
  for (const xmlNode* child : child_elements(node)) {
    if (svg_name(child) == "style") {
      const std::string type = lower(attribute(child, "type").value_or("text/css"));
      if (trimmed(type) == "text/css") add_rules(without_comments(text_of(child->children, child)));
    } else {
      read_below(child);
    }
  }
}

void StyleSheet::add_rules(std::string_view css) {
  for (std::size_t start = 0; start < css.size();) {
    const std::size_t open = find_outside(css, "{;", start);
    const std::string_view prelude = trimmed(css.substr(start, open - start));
    if (open == css.size() || css[open] == ';') {
      start = open + 1;
      continue;
    }
    const std::size_t end = block_end(css, open);
    std::string_view body = css.substr(open + 1, end - open - 1);
    if (body.ends_with('}')) body.remove_suffix(1);
    if (!prelude.starts_with('@')) add_rule(prelude, body);
    start = end;
  }
}

void StyleSheet::add_rule(std::string_view selectors, std::string_view body) {
  const Declarations declarations = parse_declarations(body);
  ++count_;
  for (std::size_t start = 0; start < selectors.size();) {
    const std::size_t comma = std::min(selectors.find(',', start), selectors.size());
    const std::string_view selector = trimmed(selectors.substr(start, comma - start));
    if (is_simple_selector(selector))
      for (const auto& [property, value] : declarations)
        rules_[std::string(selector)][property] = {value, count_};
    start = comma + 1;
  }
}

const StyleSheet::Declaration* StyleSheet::find(const std::string& selector,
                                                std::string_view property) const {
  const auto rule = rules_.find(selector);
  if (rule == rules_.end()) return nullptr;
  const auto found = rule->second.find(property);
  return found == rule->second.end() ? nullptr : &found->second;
}

std::optional<std::string> StyleSheet::from_rules(const xmlNode* node,
                                                  std::string_view property) const {
  if (rules_.empty()) return std::nullopt;
  const Declaration* best = nullptr;
  if (const auto id = attribute(node, "id")) best = find("#" + *id, property);
  if (!best)
    for (const std::string& name : split_words(attribute(node, "class").value_or(""))) {
      const Declaration* found = find("." + name, property);
      if (found && (!best || found->order > best->order)) best = found;
    }
  if (!best) best = find(std::string(svg_name(node)), property);
  return best ? std::optional(best->value) : std::nullopt;
}

std::optional<std::string> StyleSheet::declared(const xmlNode* node, std::string_view property,
                                                Accepts accepts) const {
  const auto counts = [&](std::string_view value) { return !accepts || accepts(value); };
  if (const auto style = attribute(node, "style")) {
    const auto list = declaration_list(*style);
    const auto last = std::find_if(list.rbegin(), list.rend(), [&](const auto& declaration) {
      return declaration.first == property && counts(declaration.second);
    });
    if (last != list.rend()) return last->second;
  }
  if (auto value = from_rules(node, property); value && counts(*value)) return value;
  if (const auto value = attribute(node, std::string(property).c_str()))
    if (const std::string_view text = trimmed(*value); counts(text)) return std::string(text);
  return std::nullopt;
}

std::optional<std::string> StyleSheet::inherited(const xmlNode* node,
                                                 std::string_view property) const {
  for (; node; node = parent_element(node)) {
    auto value = declared(node, property);
    if (value && lower(*value) != "inherit") return value;
  }
  return std::nullopt;
}

}  // namespace gradmesh
