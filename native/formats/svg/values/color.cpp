#include "formats/svg/values/color.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/ext/vector_uint3.hpp>

#include "formats/svg/values/color_function.h"
#include "formats/svg/values/color_names.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

glm::dvec3 from_bytes(std::uint32_t rgb) {
  return glm::dvec3((rgb >> 16) & 255, (rgb >> 8) & 255, rgb & 255) / 255.0;
}

std::optional<glm::dvec4> parse_name(std::string_view text) {
  const std::string name = lower(text.substr(0, text.find_first_of("; \t\r\n\f")));
  if (name == "transparent") return glm::dvec4(0.0);
  const auto found = std::lower_bound(
      std::begin(named_colors), std::end(named_colors), name,
      [](const NamedColor& color, std::string_view wanted) { return color.name < wanted; });
  if (found == std::end(named_colors) || found->name != name) return std::nullopt;
  return glm::dvec4(from_bytes(found->rgb), 1);
}

std::size_t hex_digits(std::string_view text) {
  return std::min(text.find_first_not_of("0123456789abcdefABCDEF"), text.size());
}

std::optional<glm::dvec4> parse_hex(std::string_view text) {
  const std::size_t count = hex_digits(text);
  if (count != 3 && count != 4 && count != 6 && count != 8) return std::nullopt;
  // Each of three or four digits is doubled.
  std::string digits;
  for (const char digit : text.substr(0, count)) digits.append(count < 6 ? 2 : 1, digit);
  if (digits.size() == 6) digits += "ff";
  std::uint32_t rgba = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), rgba, 16);
  return glm::dvec4(from_bytes(rgba >> 8), (rgba & 255) / 255.0);
}

}  // namespace

std::optional<glm::dvec4> parse_translucent_color(std::string_view text) {
  const std::string_view value = trimmed(text);
  if (value.starts_with('#')) return parse_hex(value.substr(1));
  Scanner scanner(value);
  const auto color = read_color_function(scanner);
  return color ? color : parse_name(value);
}

std::optional<glm::dvec3> parse_color(std::string_view text) {
  const auto color = parse_translucent_color(text);
  return color && color->a == 1 ? std::optional(glm::dvec3(*color)) : std::nullopt;
}

std::string color_text(const glm::dvec3& color) {
  const auto rgb = glm::uvec3(glm::round(color * 255.0));
  const glm::uvec3 digits = rgb / 17u;
  const bool is_short = 17u * digits == rgb;
  const glm::uvec3 shown = is_short ? digits : rgb;
  char hex[8];
  std::snprintf(hex, sizeof hex, is_short ? "#%x%x%x" : "#%02x%02x%02x", shown.r, shown.g, shown.b);
  return hex;
}

std::string own_color_text(std::string_view text) {
  std::string_view value = trimmed(text);
  if (value.starts_with('#')) {
    const std::size_t count = hex_digits(value.substr(1));
    const bool is_plain = count == 3 || count == 6;
    const std::string_view more = trimmed(value.substr(count + 1));
    if (!parse_hex(value.substr(1))) return "";
    if (!more.starts_with("icc-color("))
      return std::string(is_plain ? "" : value.substr(0, count + 1));
    value = value.substr(0, value.find(')') + 1);
  } else {
    Scanner scanner(value);
    if (!read_color_function(scanner)) return "";
    value = value.substr(0, value.size() - scanner.rest().size());
  }
  // What could end a declaration, or the list that remembers such texts.
  return std::string(value.find_first_of(";{}!\\\"'") == value.npos ? value : "");
}

}  // namespace gradmesh
