#include "formats/svg/values/rules.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "formats/svg/values/css_text.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

/// Returns true if the value is made of what CSS 2 knows: words, numbers, strings, functions.
bool is_plain_value(std::string_view value) {
  for (std::size_t i = 0; i < value.size();) {
    const char c = value[i];
    const std::string_view rest = value.substr(i);
    if (rest.starts_with("url(")) {
      const std::size_t size = css_url_size(rest);
      if (size == 0) return false;
      i += size;
    } else if (c == '"' || c == '\'') {
      const std::size_t size = css_string_size(rest);
      if (size == 1) return false;
      i += size;
    } else if (std::string_view("!:=$@[]{}<>&?|~^;*").find(c) != std::string_view::npos) {
      return false;
    } else {
      ++i;
    }
  }
  return true;
}

/// Ends the reading of a style element, none of which counts.
struct BrokenSheet {};

class RulesReader {
 public:
  explicit RulesReader(std::string_view css) : rest_(css) {}

  std::vector<StyleRule> read() {
    for (skip_blanks(); !rest_.empty(); skip_blanks())
      if (rest_.front() == '@') {
        read_at_rule();
      } else if (auto rule = read_rule()) {
        rules_.push_back(std::move(*rule));
      }
    return std::move(rules_);
  }

 private:
  void skip_blanks() {
    for (;;) {
      if (rest_.empty()) return;
      if (is_blank(rest_.front())) {
        rest_.remove_prefix(1);
      } else if (rest_.starts_with("/*")) {
        skip_comment();
      } else if (rest_.starts_with("<!--")) {
        rest_.remove_prefix(4);
      } else if (rest_.starts_with("-->")) {
        rest_.remove_prefix(3);
      } else {
        return;
      }
    }
  }

  void skip_comment() {
    const std::size_t end = rest_.find("*/", 2);
    if (end == rest_.npos) throw BrokenSheet();
    rest_.remove_prefix(end + 2);
  }

  /// Returns the text before the next of `ends` that is neither in a string nor in brackets, with
  /// blanks for comments.
  std::string take_until(std::string_view ends) {
    std::string text, open;
    while (!rest_.empty()) {
      const char c = rest_.front();
      if (open.empty() && ends.find(c) != ends.npos) return text;
      if (rest_.starts_with("/*")) {
        skip_comment();
        text += ' ';
        continue;
      }
      std::size_t size = 1;
      if (c == '"' || c == '\'') size = css_string_size(rest_);
      if (c == '\\' && rest_.size() > 1) size = 2;
      if (c == '(') open += ')';
      if (c == '[') open += ']';
      if (c == '{') open += '}';
      if (c == ')' || c == ']' || c == '}') {
        if (open.empty() || open.back() != c) throw BrokenSheet();
        open.pop_back();
      }
      text += rest_.substr(0, size);
      rest_.remove_prefix(size);
    }
    throw BrokenSheet();
  }

  /// Returns nothing for a rule that does not count.
  std::optional<StyleRule> read_rule() {
    const std::string selectors = take_until("{;}");
    if (rest_.front() != '{') throw BrokenSheet();
    rest_.remove_prefix(1);
    StyleRule rule;
    bool counts = true;
    for (skip_blanks(); !rest_.starts_with('}'); skip_blanks()) {
      if (rest_.starts_with(';')) {
        rest_.remove_prefix(1);
        continue;
      }
      StyleDeclaration& declaration = rule.declarations.emplace_back();
      declaration.property = take_css_name(rest_);
      skip_blanks();
      if (declaration.property.empty() || !rest_.starts_with(':')) throw BrokenSheet();
      rest_.remove_prefix(1);
      const std::string text = take_until(";}");
      std::string_view value = trimmed(text);
      if (value.empty()) throw BrokenSheet();
      declaration.is_important = take_important(value);
      declaration.value = value;
      counts = counts && is_plain_value(value);
    }
    rest_.remove_prefix(1);
    rule.selectors = parse_selectors(selectors);
    return counts && !rule.selectors.empty() ? std::optional(std::move(rule)) : std::nullopt;
  }

  void read_at_rule() {
    const std::string prelude = take_until("{;");
    const bool has_block = rest_.front() == '{';
    rest_.remove_prefix(1);
    if (!has_block) return;
    const std::string_view block = rest_;
    take_until("}");
    const std::string_view behind = rest_.substr(1);
    if (is_media(prelude)) {
      rest_ = block;
      read_media();
    }
    rest_ = behind;
  }

  /// Reads rules up to the end of the block, or the first that does not count.
  void read_media() {
    try {
      for (skip_blanks(); !rest_.empty() && rest_.front() != '}'; skip_blanks()) {
        if (rest_.front() == '@') break;
        auto rule = read_rule();
        if (!rule) return;
        rules_.push_back(std::move(*rule));
      }
    } catch (const BrokenSheet&) {
      return;
    }
    if (rest_.starts_with('@')) throw BrokenSheet();
  }

  /// Returns true for `@media` and names between commas.
  static bool is_media(std::string_view prelude) {
    constexpr std::string_view media = "@media";
    if (!prelude.starts_with(media)) return false;
    prelude.remove_prefix(media.size());
    do {
      prelude = trimmed(prelude);
      if (prelude.starts_with(',')) prelude = trimmed(prelude.substr(1));
      if (take_css_name(prelude).empty()) return false;
      prelude = trimmed(prelude);
    } while (prelude.starts_with(','));
    return prelude.empty();
  }

  std::string_view rest_;
  std::vector<StyleRule> rules_;
};

}  // namespace

bool take_important(std::string_view& value) {
  constexpr std::string_view important = "important";
  if (!value.ends_with(important)) return false;
  const std::string_view before = trimmed(value.substr(0, value.size() - important.size()));
  if (!before.ends_with('!')) return false;
  value = trimmed(before.substr(0, before.size() - 1));
  return true;
}

std::vector<StyleRule> parse_style_rules(std::string_view css) {
  try {
    return RulesReader(css).read();
  } catch (const BrokenSheet&) {
    return {};
  }
}

}  // namespace gradmesh
