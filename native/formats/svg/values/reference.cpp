#include "formats/svg/values/reference.h"

#include "formats/svg/values/css_text.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

/// Returns what is behind the last slash of a path.
std::string_view file_name(std::string_view path) {
  return path.substr(path.find_last_of("/\\") + 1);
}

/// Returns true if an address without its `#id` is that of the document.
bool is_own(std::string_view address, std::string_view file) {
  if (address.empty() || address == file) return true;
  if (address.starts_with("./")) address.remove_prefix(2);
  return !file.empty() && address == file_name(file);
}

/// Returns the byte that an escape such as `%41` in front stands for; -1 where there is none.
int escaped_byte(std::string_view text) {
  if (!text.starts_with('%') || text.size() < 3) return -1;
  const int high = hex_digit(text[1]), low = hex_digit(text[2]);
  return high < 0 || low < 0 ? -1 : high * 16 + low;
}

bool has_stray_percent(std::string_view text) {
  for (std::size_t at = text.find('%'); at != text.npos; at = text.find('%', at + 1))
    if (escaped_byte(text.substr(at)) < 0) return true;
  return false;
}

}  // namespace

std::string percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (const int code = escaped_byte(text.substr(i)); code >= 0) {
      decoded += char(code);
      i += 2;
    } else {
      decoded += text[i];
    }
  return decoded;
}

std::optional<std::string> linked_id(std::string_view link, std::string_view file) {
  const std::size_t hash = link.find('#');
  if (hash == link.npos || hash + 1 == link.size()) return std::nullopt;
  if (has_stray_percent(link) || !is_own(percent_decoded(link.substr(0, hash)), file))
    return std::nullopt;
  return percent_decoded(link.substr(hash + 1));
}

std::optional<std::string> referenced_id(std::string_view value, std::string_view file) {
  if (!value.starts_with("url")) return std::nullopt;
  const std::string_view rest = trimmed(value.substr(3));
  const std::size_t close = rest.find(')');
  if (!rest.starts_with('(') || close == rest.npos) return std::nullopt;
  std::string_view link = trimmed(rest.substr(1, close - 1));
  if (link.size() >= 2 && (link.front() == '"' || link.front() == '\'') &&
      link.back() == link.front())
    link = link.substr(1, link.size() - 2);
  return linked_id(link, file);
}

std::string fallback_color(std::string_view paint) {
  const std::size_t close = paint.find(')');
  return close == paint.npos ? "" : std::string(trimmed(paint.substr(close + 1)));
}

}  // namespace gradmesh
