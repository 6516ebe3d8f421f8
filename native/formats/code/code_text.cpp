#include "formats/code/code_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace gradmesh {
namespace {

constexpr int code_decimals = 5;
constexpr std::int64_t steps_of_one = 100000;

/// Returns the length of the well-formed character with which a text in UTF-8 begins, and its code
/// in `code`; 0 if there is none.
std::size_t utf8_character(std::string_view text, char32_t& code) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80                     ? 1
                             : first >= 0xC2 && first <= 0xDF ? 2
                             : first >= 0xE0 && first <= 0xEF ? 3
                             : first >= 0xF0 && first <= 0xF4 ? 4
                                                              : 0;
  if (length == 0 || text.size() < length) return 0;
  code = length == 1 ? first : first & (0x7F >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
    code = (code << 6) | (byte(i) & 0x3F);
  }
  const bool is_overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool is_none = (code >= 0xD800 && code <= 0xDFFF) || code > 0x10FFFF;
  return is_overlong || is_none ? 0 : length;
}

/// Returns true for controls, ends of lines and what turns the direction of reading, by which code
/// could look like something else.
bool is_unseen(char32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x061C ||
         (code >= 0x200B && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) ||
         (code >= 0x2060 && code <= 0x206F) || code == 0xFEFF || code >= 0xE0000;
}

}  // namespace

std::int64_t code_steps(double coordinate) {
  constexpr double farthest = 1e6;
  if (!std::isfinite(coordinate)) return 0;
  return std::llround(std::clamp(coordinate, -farthest, farthest) * double(steps_of_one));
}

std::string code_number(std::int64_t steps) {
  const std::int64_t size = std::abs(steps);
  std::string number = (steps < 0 ? "-" : "") + std::to_string(size / steps_of_one);
  std::string decimals = std::to_string(size % steps_of_one);
  decimals.insert(0, std::size_t(code_decimals) - decimals.size(), '0');
  decimals.erase(decimals.find_last_not_of('0') + 1);
  return decimals.empty() ? number : number + "." + decimals;
}

std::string code_ratio(double value) {
  char text[32];
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6).ptr;
  return {text, end};
}

std::string code_color(const glm::dvec4& color) {
  const auto byte = [](double channel) {
    return unsigned(std::lround(255 * std::clamp(channel, 0.0, 1.0)));
  };
  char text[16];
  std::snprintf(text, sizeof text, "0x%02X%02X%02X%02X", byte(color.a), byte(color.r),
                byte(color.g), byte(color.b));
  return text;
}

std::string comment_text(std::string_view text) {
  constexpr std::size_t longest = 80;
  std::string shown;
  while (!text.empty()) {
    if (shown.size() > longest) return shown + "...";
    char32_t code = 0;
    const std::size_t length = utf8_character(text, code);
    // A comment may be put into another one, which such pairs would begin or end.
    const bool joins = !shown.empty() && ((shown.back() == '/' && code == '*') ||
                                          (shown.back() == '*' && code == '/'));
    if (length == 0 || is_unseen(code) || joins)
      shown += '?';
    else
      shown += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return shown;
}

std::string code_lines(const CodeLines& lines, int indent, std::string_view suffix) {
  std::string text;
  for (const std::vector<std::string>& line : lines) {
    text.append(std::size_t(indent), ' ');
    for (std::size_t i = 0; i < line.size(); ++i)
      text.append(i == 0 ? "" : " ").append(line[i]).append(suffix).append(",");
    text += '\n';
  }
  return text;
}

CodeLines outline_points(const FilledOutline& clip) {
  constexpr std::size_t points_a_line = 5;
  CodeLines lines;
  for (const std::vector<glm::dvec2>& polygon : clip.outline)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      if (i % points_a_line == 0) lines.emplace_back();
      lines.back().push_back(code_number(code_steps(polygon[i].x)));
      lines.back().push_back(code_number(code_steps(polygon[i].y)));
    }
  return lines;
}

CodeLines outline_counts(const FilledOutline& clip) {
  constexpr std::size_t counts_a_line = 16;
  CodeLines lines;
  for (std::size_t i = 0; i < clip.outline.size(); ++i) {
    if (i % counts_a_line == 0) lines.emplace_back();
    lines.back().push_back(std::to_string(clip.outline[i].size()));
  }
  return lines;
}

CodeLines vertex_colors(const MeshCode& mesh) {
  constexpr std::size_t colors_a_line = 8;
  CodeLines lines;
  for (const CodeGrid& grid : mesh.grids)
    for (std::size_t i = 0; i < grid.vertices.size(); ++i) {
      if (i % std::size_t(grid.columns + 1) % colors_a_line == 0) lines.emplace_back();
      lines.back().push_back(code_color(grid.vertices[i].color));
    }
  return lines;
}

}  // namespace gradmesh
