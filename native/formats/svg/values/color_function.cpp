#include "formats/svg/values/color_function.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <span>

#include "formats/svg/values/color_spaces.h"

namespace gradmesh {
namespace {

/// What an argument of a colour function without a unit is divided by, and what 100% stands for.
struct Argument {
  double whole = 1, of_percent = 1;
  bool is_hue = false;
};

using ArgumentTriple = std::array<Argument, 3>;

constexpr Argument angle{1, 360, true}, hundredth{100, 1};
constexpr ArgumentTriple shares{};

template <glm::dvec3 (*to_rgb)(const glm::dvec3&)>
glm::dvec3 of_three(const glm::dvec4& v) {
  return to_rgb(glm::dvec3(v));
}

glm::dvec3 as_it_is(const glm::dvec4& v) { return glm::dvec3(v); }

/// A function of CSS Color 4, or a space of its color().
struct ColorFunction {
  std::string_view name;
  ArgumentTriple arguments;
  glm::dvec3 (*to_rgb)(const glm::dvec4&);
  bool has_fourth = false;
};

/// What 100% stands for says CSS Color 4 (sections 5.1, 7, 8, 9.3 and 9.4). Inkscape 1.5 writes
/// hsl() and hwb() without `%`, and reads a hue with it.
constexpr ArgumentTriple of_rgb{{{255, 1}, {255, 1}, {255, 1}}};
constexpr ArgumentTriple of_hsl{{angle, hundredth, hundredth}};
constexpr ArgumentTriple of_lab{{{1, 100}, {1, 125}, {1, 125}}};
constexpr ArgumentTriple of_lch{{{1, 100}, {1, 150}, angle}};
constexpr ArgumentTriple of_oklab{{{1, 1}, {1, 0.4}, {1, 0.4}}};
constexpr ArgumentTriple of_oklch{{{1, 1}, {1, 0.4}, angle}};

constexpr ColorFunction functions[] = {
    {"rgb", of_rgb, as_it_is},
    {"rgba", of_rgb, as_it_is},
    {"hsl", of_hsl, of_three<hsl_to_rgb>},
    {"hsla", of_hsl, of_three<hsl_to_rgb>},
    {"hwb", of_hsl, of_three<hwb_to_rgb>},
    {"lab", of_lab, of_three<lab_to_rgb>},
    {"lch", of_lch, of_three<lch_to_rgb>},
    {"oklab", of_oklab, of_three<oklab_to_rgb>},
    {"oklch", of_oklch, of_three<oklch_to_rgb>},
    {"device-cmyk", shares, cmyk_to_rgb, true},
};

constexpr ColorFunction spaces[] = {
    {"srgb", shares, as_it_is},
    {"srgb-linear", shares, of_three<srgb_linear_to_rgb>},
    {"display-p3", shares, of_three<display_p3_to_rgb>},
    {"a98-rgb", shares, of_three<a98_to_rgb>},
    {"prophoto-rgb", shares, of_three<prophoto_to_rgb>},
    {"rec2020", shares, of_three<rec2020_to_rgb>},
    {"xyz", shares, of_three<xyz_d65_to_rgb>},
    {"xyz-d65", shares, of_three<xyz_d65_to_rgb>},
    {"xyz-d50", shares, of_three<xyz_d50_to_rgb>},
};

const ColorFunction* function_named(std::span<const ColorFunction> all, std::string_view name) {
  const auto found = std::ranges::find(all, lower(name), &ColorFunction::name);
  return found != all.end() ? &*found : nullptr;
}

/// Returns the size of a unit of angle in degrees (CSS Values 4, section 7.1).
std::optional<double> degrees_of(std::string_view unit) {
  if (unit == "deg") return 1;
  if (unit == "grad") return 0.9;
  if (unit == "rad") return 180 / std::numbers::pi;
  if (unit == "turn") return 360;
  return std::nullopt;
}

std::optional<double> read_argument(Scanner& scanner, const Argument& argument) {
  const auto value = scanner.number();
  if (!value) return lower(scanner.word()) == "none" ? std::optional(0.0) : std::nullopt;
  // A unit follows without a blank.
  const std::string_view rest = scanner.rest();
  if (rest.starts_with('%') && scanner.accept('%')) return *value / 100 * argument.of_percent;
  if (rest.empty() || !std::isalpha(static_cast<unsigned char>(rest.front())))
    return *value / argument.whole;
  const auto degrees = degrees_of(lower(scanner.word()));
  return argument.is_hue && degrees ? std::optional(*value * *degrees) : std::nullopt;
}

/// Reads the arguments of a function, and the opacity behind them, up to the closing parenthesis.
std::optional<glm::dvec4> read_arguments(Scanner& scanner, const ColorFunction& function) {
  glm::dvec4 values(0.0);
  for (int i = 0; i < (function.has_fourth ? 4 : 3); ++i) {
    if (i > 0) scanner.skip_comma();
    const auto value =
        read_argument(scanner, i < 3 ? function.arguments[std::size_t(i)] : Argument());
    if (!value) return std::nullopt;
    values[i] = *value;
  }
  double opacity = 1;
  if (scanner.accept('/') || scanner.accept(',')) {
    const auto value = read_argument(scanner, {});
    if (!value) return std::nullopt;
    opacity = *value;
  }
  if (!scanner.accept(')')) return std::nullopt;
  return glm::clamp(glm::dvec4(function.to_rgb(values), opacity), 0.0, 1.0);
}

}  // namespace

std::optional<glm::dvec4> read_color_function(Scanner& scanner) {
  const std::string_view name = scanner.word();
  if (!scanner.rest().starts_with('(')) return std::nullopt;
  scanner.accept('(');
  const ColorFunction* const function = lower(name) == "color"
                                            ? function_named(spaces, scanner.word())
                                            : function_named(functions, name);
  return function ? read_arguments(scanner, *function) : std::nullopt;
}

}  // namespace gradmesh
