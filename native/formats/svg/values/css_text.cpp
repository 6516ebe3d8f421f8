#include "formats/svg/values/css_text.h"

#include <algorithm>

namespace gradmesh {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

bool is_odd_letter(std::string_view text) {
  return text.size() >= 2 && text[0] == '\xc2' && static_cast<unsigned char>(text[1]) <= 0xb1;
}

namespace {

constexpr std::string_view url_start = "url(";

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

std::string utf8(int code) {
  if (code < 0x80) return {char(code)};
  std::string text;
  const auto add = [&](int lead, int shift) {
    text += char(lead | code >> shift);
    for (shift -= 6; shift >= 0; shift -= 6) text += char(0x80 | (code >> shift & 0x3f));
  };
  if (code < 0x800)
    add(0xc0, 6);
  else if (code < 0x10000)
    add(0xe0, 12);
  else
    add(0xf0, 18);
  return text;
}

/// Takes an escape off the front: of any character by its number, or of a blank or a character
/// from U+00C8 on by itself.
bool take_escape(std::string_view& text, std::string& name) {
  constexpr std::size_t most_digits = 6;
  constexpr int last_code = 0x10ffff;
  std::size_t i = 1;
  int code = 0;
  for (; i < text.size() && i <= most_digits && hex_digit(text[i]) >= 0; ++i)
    code = code * 16 + hex_digit(text[i]);
  if (i > 1) {
    if (code == 0 || code > last_code) return false;
    if (i < text.size() && (text[i] == ' ' || text[i] == '\t' || text[i] == '\n')) ++i;
    name += utf8(code);
  } else if (text.size() > 1 && text[1] == ' ') {
    name += text[i++];
  } else if (text.size() > 2 && static_cast<unsigned char>(text[1]) >= 0xc3 &&
             !(text[1] == '\xc3' && static_cast<unsigned char>(text[2]) < 0x88)) {
    name += text[i++];  // The rest of it are letters anyway.
  } else {
    return false;
  }
  text.remove_prefix(i);
  return true;
}

}  // namespace

std::string take_css_letters(std::string_view& text) {
  std::string name;
  while (!text.empty()) {
    const char c = text.front();
    if (is_odd_letter(text)) break;
    if (is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_') {
      name += c;
      text.remove_prefix(1);
    } else if (c != '\\' || !take_escape(text, name)) {
      break;
    }
  }
  return name;
}

std::string take_css_name(std::string_view& text) {
  const std::size_t first = text.starts_with('-') ? 1 : 0;
  if (first >= text.size() || !(is_letter(text[first]) || text[first] == '\\')) return "";
  return take_css_letters(text);
}

std::size_t css_string_size(std::string_view text) {
  for (std::size_t i = 1; i < text.size() && text[i] != '\n'; ++i) {
    if (text[i] == '\\')
      ++i;
    else if (text[i] == text.front())
      return i + 1;
  }
  return 1;
}

std::size_t css_url_size(std::string_view text) {
  const std::size_t first =
      std::min(text.find_first_not_of(" \t\r\n", url_start.size()), text.size());
  const char quote = first < text.size() ? text[first] : ' ';
  std::size_t i = first;
  if (quote == '"' || quote == '\'') {
    i += css_string_size(text.substr(first));
    return i == first + 1 ? 0 : std::min(text.find(')', i), text.size() - 1) + 1;
  }
  for (; i < text.size() && text[i] != ')'; ++i)
    if (std::string_view("'\"(").find(text[i]) != std::string_view::npos ||
        is_odd_letter(text.substr(i)))
      return 0;
  return std::min(i + 1, text.size());
}

bool has_broken_url(std::string_view value) {
  for (std::size_t at = value.find(url_start); at != value.npos; at = value.find(url_start, at + 1))
    if (css_url_size(value.substr(at)) == 0) return true;
  return false;
}

}  // namespace gradmesh
