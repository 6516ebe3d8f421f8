#include "formats/svg/values/moved_css.h"

#include <algorithm>

#include "formats/svg/values/css_text.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

bool is_quote(char c) { return c == '"' || c == '\''; }

/// Returns true if the text begins with the word, in letters of any case.
bool begins_with(std::string_view text, std::string_view word) {
  const auto is_same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a | 0x20 : a) == b; };
  return std::ranges::equal(text.substr(0, word.size()), word, is_same);
}

bool is_url(std::string_view css) { return begins_with(css, "url("); }

std::size_t comment_size(std::string_view css) {
  const std::size_t end = css.find("*/", 2);
  return end == css.npos ? css.size() : end + 2;
}

/// Returns the number of bytes of what has to be taken as a whole off the front: a comment, a
/// string, a `url(…)`, an escape, a name, or else one byte.
std::size_t token_size(std::string_view css) {
  if (css.starts_with("/*")) return comment_size(css);
  if (is_quote(css.front())) return css_string_size(css);
  if (const std::size_t url = is_url(css) ? css_url_size(css) : 0) return url;
  if (css.front() == '\\') return std::min<std::size_t>(css.size(), 2);
  std::string_view rest = css;
  take_css_letters(rest);
  return std::max<std::size_t>(css.size() - rest.size(), 1);
}

/// Returns what is between the quotes of a string; nothing if it is not closed.
std::string_view inside(std::string_view string) {
  return string.size() < 2 ? std::string_view() : string.substr(1, string.size() - 2);
}

/// Returns the part of a `url(…)` that is the address.
std::string_view address_of(std::string_view url) {
  const std::string_view content = trimmed(url.substr(url.find('(') + 1));
  if (!content.empty() && is_quote(content.front()))
    return inside(content.substr(0, css_string_size(content)));
  return trimmed(content.substr(0, content.find(')')));
}

/// Goes through a style sheet, token by token.
class AddressSearch {
 public:
  /// Returns the address that the next token holds; nothing if it is another token.
  std::string_view address(std::string_view token) {
    if (token.starts_with("/*") || trimmed(token).empty()) return {};
    const bool is_imported = is_imported_;
    is_imported_ = is_rule_ && token.size() == 6 && begins_with(token, "import");
    is_rule_ = token == "@";
    if (is_url(token)) return address_of(token);
    return is_imported && is_quote(token.front()) ? inside(token) : std::string_view();
  }

 private:
  /// True behind `@`, and behind `@import`.
  bool is_rule_ = false, is_imported_ = false;
};

}  // namespace

std::optional<std::string> moved_css(std::string_view css, const FolderMove& move) {
  std::string result;
  bool is_changed = false;
  AddressSearch search;
  while (!css.empty()) {
    const std::string_view token = css.substr(0, token_size(css));
    const std::string_view address = search.address(token);
    const auto moved = moved_link(address, move);
    if (moved) {
      const auto at = std::size_t(address.data() - token.data());
      result += token.substr(0, at);
      result += *moved;
      result += token.substr(at + address.size());
      is_changed = true;
    } else {
      result += token;
    }
    css.remove_prefix(token.size());
  }
  if (!is_changed) return std::nullopt;
  return result;
}

}  // namespace gradmesh
