#include "formats/svg/values/color.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/ext/vector_uint3.hpp>

#include "formats/svg/values/color_names.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

glm::dvec3 from_bytes(std::uint32_t rgb) {
  return glm::dvec3((rgb >> 16) & 255, (rgb >> 8) & 255, rgb & 255) / 255.0;
}

std::optional<glm::dvec3> parse_name(std::string_view text) {
  const std::string name = lower(text.substr(0, text.find_first_of("; \t\r\n\f")));
  const auto found = std::lower_bound(
      std::begin(named_colors), std::end(named_colors), name,
      [](const NamedColor& color, std::string_view wanted) { return color.name < wanted; });
  if (found == std::end(named_colors) || found->name != name) return std::nullopt;
  return from_bytes(found->rgb);
}

std::optional<glm::dvec3> parse_hex(std::string_view text) {
  const std::size_t count = std::min(text.find_first_not_of("0123456789abcdefABCDEF"), text.size());
  if (count != 3 && count != 6) return std::nullopt;
  std::uint32_t rgb = 0;
  std::from_chars(text.data(), text.data() + count, rgb, 16);
  // Each of three digits is doubled.
  if (count == 3) rgb = 0x11 * ((rgb & 0xf00) << 8 | (rgb & 0x0f0) << 4 | (rgb & 0x00f));
  return from_bytes(rgb);
}

/// An argument of a colour function; `percent` is true if '%' followed.
struct Argument {
  double value = 0;
  bool percent = false;
};

/// Reads three arguments separated by commas, up to the closing parenthesis.
std::optional<std::array<Argument, 3>> parse_arguments(Scanner scanner) {
  std::array<Argument, 3> arguments;
  for (Argument& argument : arguments) {
    if (&argument != &arguments.front() && !scanner.accept(',')) return std::nullopt;
    const auto value = scanner.number();
    if (!value) return std::nullopt;
    argument = {*value, scanner.accept('%')};
  }
  return scanner.accept(')') ? std::optional(arguments) : std::nullopt;
}

/// Returns the colour in RGB, by CSS Color 4, section 7.1; `hue` is in degrees.
glm::dvec3 hsl_to_rgb(double hue, double saturation, double lightness) {
  const double chroma = saturation * std::min(lightness, 1 - lightness);
  const auto channel = [&](double n) {
    double k = std::fmod(n + hue / 30.0, 12.0);
    if (k < 0) k += 12.0;
    return lightness - chroma * std::max(-1.0, std::min({k - 3.0, 9.0 - k, 1.0}));
  };
  return {channel(0), channel(8), channel(4)};
}

std::optional<glm::dvec3> parse_rgb(std::string_view text) {
  const auto arguments = parse_arguments(Scanner(text));
  if (!arguments) return std::nullopt;
  const auto& [r, g, b] = *arguments;
  if (r.percent != g.percent || g.percent != b.percent) return std::nullopt;
  const glm::dvec3 values(r.value, g.value, b.value);
  return glm::clamp(values / (r.percent ? 100.0 : 255.0), 0.0, 1.0);
}

std::optional<glm::dvec3> parse_hsl(std::string_view text) {
  const auto arguments = parse_arguments(Scanner(text));
  if (!arguments) return std::nullopt;
  const auto& [hue, saturation, lightness] = *arguments;
  if (hue.percent || !saturation.percent || !lightness.percent) return std::nullopt;
  return hsl_to_rgb(hue.value, std::clamp(saturation.value / 100, 0.0, 1.0),
                    std::clamp(lightness.value / 100, 0.0, 1.0));
}

}  // namespace

std::optional<glm::dvec3> parse_color(std::string_view text) {
  const std::string_view value = trimmed(text);
  if (value.starts_with('#')) return parse_hex(value.substr(1));
  if (value.starts_with("rgb(")) return parse_rgb(value.substr(4));
  if (value.starts_with("hsl(")) return parse_hsl(value.substr(4));
  return parse_name(value);
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

}  // namespace gradmesh
