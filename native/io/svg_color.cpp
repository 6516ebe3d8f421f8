#include "io/svg_color.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "io/svg_color_names.h"
#include "io/svg_scanner.h"

namespace gradmesh {
namespace {

glm::dvec4 from_bytes(std::uint32_t rgba) {
  return glm::dvec4(rgba >> 24, (rgba >> 16) & 255, (rgba >> 8) & 255, rgba & 255) / 255.0;
}

std::optional<glm::dvec4> parse_name(std::string_view name) {
  if (name == "transparent") return glm::dvec4(0.0);
  const auto found = std::lower_bound(
      std::begin(named_colors), std::end(named_colors), name,
      [](const NamedColor& color, std::string_view wanted) { return color.name < wanted; });
  if (found == std::end(named_colors) || found->name != name) return std::nullopt;
  return from_bytes(found->rgb << 8 | 255);
}

std::optional<glm::dvec4> parse_hex(std::string_view digits) {
  std::string full;
  if (digits.size() == 3 || digits.size() == 4) {
    for (char digit : digits) full.append(2, digit);
  } else {
    full = digits;
  }
  if (full.size() == 6) full += "ff";
  std::uint32_t rgba = 0;
  const auto [end, error] = std::from_chars(full.data(), full.data() + full.size(), rgba, 16);
  if (full.size() != 8 || error != std::errc() || end != full.data() + full.size())
    return std::nullopt;
  return from_bytes(rgba);
}

/// An argument of a colour function; `percent` says that '%' followed it.
struct Argument {
  double value = 0;
  bool percent = false;
};

/// Three or four arguments between parentheses, apart by commas or blanks, the fourth also by '/'.
std::optional<std::pair<std::array<Argument, 4>, int>> parse_arguments(Scanner& scanner) {
  std::array<Argument, 4> arguments;
  int count = 0;
  if (!scanner.accept('(')) return std::nullopt;
  while (!scanner.accept(')')) {
    if (count == 4) return std::nullopt;
    if (count > 0 && !scanner.accept(',') && count == 3) scanner.accept('/');
    const auto value = scanner.number();
    if (!value) return std::nullopt;
    if (count == 0 && scanner.peek() == 'd' && scanner.word() != "deg") return std::nullopt;
    arguments[std::size_t(count++)] = {*value, scanner.accept('%')};
  }
  if (count < 3 || !scanner.at_end()) return std::nullopt;
  return std::pair(arguments, count);
}

/// CSS Color 4, section 7.1; `hue` in degrees.
glm::dvec3 hsl_to_rgb(double hue, double saturation, double lightness) {
  const double chroma = saturation * std::min(lightness, 1 - lightness);
  const auto channel = [&](double n) {
    double k = std::fmod(n + hue / 30.0, 12.0);
    if (k < 0) k += 12.0;
    return lightness - chroma * std::max(-1.0, std::min({k - 3.0, 9.0 - k, 1.0}));
  };
  return {channel(0), channel(8), channel(4)};
}

std::optional<glm::dvec4> parse_function(std::string_view text) {
  Scanner scanner(text);
  const std::string_view name = scanner.word();
  const bool is_rgb = name == "rgb" || name == "rgba";
  if (!is_rgb && name != "hsl" && name != "hsla") return std::nullopt;
  const auto parsed = parse_arguments(scanner);
  if (!parsed) return std::nullopt;
  const std::array<Argument, 4>& arguments = parsed->first;
  const int count = parsed->second;
  const auto fraction = [&](int i, double whole) {
    const Argument& argument = arguments[std::size_t(i)];
    return std::clamp(argument.value / (argument.percent ? 100.0 : whole), 0.0, 1.0);
  };
  const double alpha = count == 4 ? fraction(3, 1) : 1.0;
  if (is_rgb) return glm::dvec4(fraction(0, 255), fraction(1, 255), fraction(2, 255), alpha);
  return glm::dvec4(hsl_to_rgb(arguments[0].value, fraction(1, 100), fraction(2, 100)), alpha);
}

}  // namespace

std::optional<glm::dvec4> parse_color(std::string_view text) {
  std::string color = lower(text);
  color.resize(std::min(color.size(), color.find("icc-color(")));
  const std::string_view value = trimmed(color);
  if (value.starts_with('#')) return parse_hex(value.substr(1));
  if (value.ends_with(')')) return parse_function(value);
  return parse_name(value);
}

}  // namespace gradmesh
