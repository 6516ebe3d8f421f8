#include "formats/svg/values/moved_link.h"

#include <algorithm>
#include <vector>

#include "formats/svg/values/reference.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

/// A part of the path in an address.
struct LinkPart {
  std::string spelled;
  /// Without percent-encoding.
  std::string name;

  bool operator==(const LinkPart& other) const { return name == other.name; }
};
using Parts = std::vector<LinkPart>;

bool is_ascii_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_ascii_digit(char c) { return c >= '0' && c <= '9'; }

/// Returns the text with all bytes encoded that mean something in an address, a style or XML. Those
/// of other letters too: a folder may have a name that is no UTF-8.
std::string percent_encoded(std::string_view text) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string encoded;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (is_ascii_letter(c) || is_ascii_digit(c) || c == '-' || c == '.' || c == '_' || c == '~')
      encoded += c;
    else
      encoded += {'%', digits[code / 16], digits[code % 16]};
  }
  return encoded;
}

/// Returns the bytes of a path in UTF-8; on Linux those that it has.
std::string utf8_of(const std::filesystem::path& path) {
  const std::u8string text = path.generic_u8string();
  return {text.begin(), text.end()};
}

Parts parts_of(const std::filesystem::path& folder) {
  Parts parts;
  for (const std::filesystem::path& part : folder.relative_path()) {
    const std::string name = utf8_of(part);
    if (!name.empty()) parts.push_back({percent_encoded(name), name});
  }
  return parts;
}

bool has_scheme(std::string_view address) {
  const auto end = std::ranges::find_if_not(address, [](char c) {
    return is_ascii_letter(c) || is_ascii_digit(c) || c == '+' || c == '-' || c == '.';
  });
  return !address.empty() && is_ascii_letter(address.front()) && end != address.end() &&
         *end == ':';
}

/// Returns true if an address leads to a file by the folder of the document. `\` begins a path of
/// Windows, which is absolute.
bool is_relative(std::string_view address) {
  constexpr std::string_view absolute = "#?/\\";
  return !address.empty() && absolute.find(address.front()) == absolute.npos &&
         !has_scheme(address);
}

/// Goes from a folder by the path of an address.
void follow(std::string_view path, Parts& parts) {
  while (true) {
    const std::size_t slash = std::min(path.find('/'), path.size());
    const std::string spelled(path.substr(0, slash)), name = percent_decoded(spelled);
    const bool is_up = name == "..";
    if (is_up && !parts.empty()) parts.pop_back();
    if (!is_up && name != ".") parts.push_back({spelled, name});
    if (slash == path.size()) return;
    path.remove_prefix(slash + 1);
  }
}

/// Returns the path from a folder to a file below the same root.
std::string relative_path(const Parts& folder, const Parts& file) {
  const std::ptrdiff_t folders_of_file = std::max<std::ptrdiff_t>(std::ssize(file) - 1, 0);
  const auto [differs, from] = std::ranges::mismatch(file.begin(), file.begin() + folders_of_file,
                                                     folder.begin(), folder.end());
  std::string path;
  for (auto up = from; up != folder.end(); ++up) path += "../";
  // At the front a colon would make a scheme of what is before it, and a slash the root.
  const bool is_clear = differs != file.end() && !differs->spelled.empty() &&
                        differs->spelled.find(':') == std::string::npos;
  if (path.empty() && !is_clear) path = "./";
  for (auto part = differs; part != file.end(); ++part)
    path += (part == differs ? "" : "/") + part->spelled;
  return path;
}

/// Returns the address of a file below a root, such as a drive of Windows.
std::string absolute_address(const std::string& root, const Parts& file) {
  std::string address = root.starts_with("//") ? "file:" + root : "file:///" + root;
  for (const LinkPart& part : file) address += "/" + part.spelled;
  return address;
}

}  // namespace

std::optional<std::string> moved_link(std::string_view link, const FolderMove& move) {
  const std::string_view address = trimmed(link);
  if (!is_relative(address)) return std::nullopt;
  const std::size_t end = std::min(address.find_first_of("?#"), address.size());
  const std::string_view behind = address.substr(end);
  Parts target = parts_of(move.file.parent_path());
  follow(address.substr(0, end), target);
  if (behind.size() > 1 && behind.front() == '#' && target == parts_of(move.file))
    return std::string(behind);
  // From one drive of Windows to another no relative path leads.
  const std::string path = move.file.root_name() == move.folder.root_name()
                               ? relative_path(parts_of(move.folder), target)
                               : absolute_address(utf8_of(move.file.root_name()), target);
  std::string moved = path + std::string(behind);
  if (moved == address) return std::nullopt;
  return moved;
}

}  // namespace gradmesh
