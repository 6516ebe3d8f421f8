#include "formats/svg/values/transform.h"

#include <array>
#include <cmath>
#include <numbers>

#include "formats/text/number.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

/// Up to six arguments between parentheses.
struct Arguments {
  std::array<double, 6> value{};
  int count = 0;
};

std::optional<Arguments> parse_arguments(Scanner& scanner) {
  Arguments arguments;
  if (!scanner.accept('(')) return std::nullopt;
  while (!scanner.accept(')')) {
    if (arguments.count == 6) return std::nullopt;
    if (arguments.count > 0) scanner.skip_comma();
    const auto number = scanner.number();
    if (!number) return std::nullopt;
    arguments.value[std::size_t(arguments.count++)] = *number;
  }
  return arguments;
}

Affine rotation(double degrees, glm::dvec2 center) {
  const double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
  const Affine turn{glm::dmat2(c, s, -s, c), glm::dvec2(0.0)};
  return Affine::translation(center) * turn * Affine::translation(-center);
}

std::optional<Affine> make_transform(std::string_view name, const Arguments& arguments) {
  const auto& v = arguments.value;
  const int count = arguments.count;
  if (name == "matrix" && count == 6)
    return Affine{glm::dmat2(v[0], v[1], v[2], v[3]), glm::dvec2(v[4], v[5])};
  if (name == "translate" && (count == 1 || count == 2)) return Affine::translation({v[0], v[1]});
  if (name == "scale" && count == 1) return Affine::scaling({v[0], v[0]});
  if (name == "scale" && count == 2) return Affine::scaling({v[0], v[1]});
  if (name == "rotate" && (count == 1 || count == 3)) return rotation(v[0], {v[1], v[2]});
  if (name == "skewX" && count == 1)
    return Affine{glm::dmat2(1, 0, std::tan(radians(v[0])), 1), glm::dvec2(0.0)};
  if (name == "skewY" && count == 1)
    return Affine{glm::dmat2(1, std::tan(radians(v[0])), 0, 1), glm::dvec2(0.0)};
  return std::nullopt;
}

bool is_finite(const Affine& affine) {
  for (const glm::dvec2 v : {affine.linear[0], affine.linear[1], affine.offset})
    if (!std::isfinite(v.x) || !std::isfinite(v.y)) return false;
  return true;
}

}  // namespace

std::optional<Affine> parse_transform(std::string_view text) {
  Affine product;
  if (trimmed(text) == "none") return product;
  Scanner scanner(text);
  while (!scanner.at_end()) {
    const std::string_view name = scanner.word();
    const auto arguments = parse_arguments(scanner);
    if (!arguments) return std::nullopt;
    const auto next = make_transform(name, *arguments);
    if (!next) return std::nullopt;
    product = product * *next;
    scanner.skip_comma();
  }
  return is_finite(product) ? std::optional(product) : std::nullopt;
}

std::string transform_text(const Affine& map) {
  const auto& [linear, offset] = map;
  std::string text = "matrix(";
  for (const double x : {linear[0].x, linear[0].y, linear[1].x, linear[1].y, offset.x, offset.y})
    text.append(text.back() == '(' ? "" : " ").append(format_number(x));
  return text + ")";
}

}  // namespace gradmesh
