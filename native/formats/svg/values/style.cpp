#include "formats/svg/values/style.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "formats/svg/values/css_text.h"
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

bool is_name(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || static_cast<unsigned char>(c) >= 0x80;
  });
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

/// Returns all declarations in their order, also of equal names. Names are as they are written:
/// Inkscape takes no capital for a small letter there.
std::vector<StyleDeclaration> declaration_list(std::string_view text) {
  const std::string clean = without_comments(text);
  const std::string_view view = clean;
  std::vector<StyleDeclaration> declarations;
  for (std::size_t start = 0; start < view.size();) {
    const std::size_t end = find_outside(view, ";", start);
    const std::string_view declaration = view.substr(start, end - start);
    const std::size_t colon = declaration.find(':');
    const std::string_view name = trimmed(declaration.substr(0, colon));
    if (colon != declaration.npos && is_name(name)) {
      std::string_view value = trimmed(declaration.substr(colon + 1));
      const bool is_important = take_important(value);
      value = trimmed(value.substr(0, find_outside(value, "!", 0)));
      declarations.push_back({std::string(name), closed(value), is_important});
    }
    start = end + 1;
  }
  return declarations;
}

}  // namespace

Declarations parse_declarations(std::string_view text) {
  Declarations declarations;
  std::set<std::string> important;
  for (auto& [name, value, is_important] : declaration_list(text)) {
    if (is_important)
      important.insert(name);
    else if (important.contains(name))
      continue;
    declarations[name] = std::move(value);
  }
  for (const std::string& name : important) declarations[name] += important_mark;
  return declarations;
}

std::string without_important(std::string_view value) {
  take_important(value);
  return std::string(value);
}

StyleSheet::StyleSheet(const xmlNode* root) { read_below(root); }

void StyleSheet::read_below(const xmlNode* node) {
  for (const xmlNode* child : child_elements(node)) {
    if (svg_name(child) == "style") {
      for (const StyleRule& rule : parse_style_rules(text_of(child->children, child))) add(rule);
    } else {
      read_below(child);
    }
  }
}

void StyleSheet::add(const StyleRule& rule) {
  for (const Selector& selector : rule.selectors) {
    selectors_.push_back(selector);
    auto& properties = rules_[selector.key()];
    for (const auto& [property, value, is_important] : rule.declarations) {
      has_important_ = has_important_ || is_important;
      properties[property].push_back(
          {value, is_important, selector.specificity(), ++count_, selectors_.size() - 1});
    }
  }
}

/// Returns the declaration of a rule that counts; null if there is none.
const StyleSheet::Declaration* StyleSheet::from_rules(const xmlNode* node,
                                                      std::string_view property) const {
  if (rules_.empty()) return nullptr;
  std::vector<std::string> keys{"*", std::string(view(node->name))};
  if (const auto id = attribute(node, "id")) keys.push_back("#" + *id);
  for (const std::string& name : split_words(attribute(node, "class").value_or("")))
    keys.push_back("." + name);
  std::vector<const Declaration*> matching;
  for (const std::string& key : keys) {
    const auto rules = rules_.find(key);
    if (rules == rules_.end()) continue;
    const auto found = rules->second.find(property);
    if (found == rules->second.end()) continue;
    for (const Declaration& declaration : found->second)
      if (selectors_[declaration.selector].matches(node)) matching.push_back(&declaration);
  }
  std::ranges::sort(matching, {}, &Declaration::order);
  const Declaration* best = nullptr;
  for (const Declaration* next : matching)
    if (!best ||
        (next->specificity >= best->specificity && (next->is_important || !best->is_important)))
      best = next;
  return best;
}

std::optional<std::string> StyleSheet::declared(const xmlNode* node, std::string_view property,
                                                Accepts accepts) const {
  const auto counts = [&](std::string_view value) { return !accepts || accepts(value); };
  const std::vector<StyleDeclaration> own = declaration_list(attribute(node, "style").value_or(""));
  const Declaration* const rule = from_rules(node, property);
  for (const bool is_important : {true, false}) {
    const auto last = std::find_if(own.rbegin(), own.rend(), [&](const StyleDeclaration& d) {
      return d.property == property && d.is_important == is_important && counts(d.value) &&
             !has_broken_url(d.value);
    });
    if (last != own.rend()) return last->value;
    if (rule && rule->is_important == is_important && counts(rule->value)) return rule->value;
  }
  if (const auto value = attribute(node, std::string(property).c_str()))
    if (const std::string_view text = trimmed(*value); counts(text)) return std::string(text);
  return std::nullopt;
}

std::vector<std::string> StyleSheet::properties(
    const std::function<bool(std::string_view)>& is_wanted) const {
  std::set<std::string> found;
  for (const auto& [key, rules] : rules_)
    for (const auto& [property, declarations] : rules)
      if (std::ranges::any_of(declarations, [&](const auto& d) { return is_wanted(d.value); }))
        found.insert(property);
  return {found.begin(), found.end()};
}

bool StyleSheet::outranks_style(const xmlNode* node, std::string_view property) const {
  const Declaration* const rule = from_rules(node, property);
  return rule && rule->is_important;
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
