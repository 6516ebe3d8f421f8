#include <cmath>
#include <string>

#include "formats/svg/tree/svg_tree.h"
#include "formats/svg/values/length.h"
#include "formats/svg/values/transform.h"
#include "formats/svg/xml/node.h"
#include "formats/text/number.h"
#include "formats/text/scanner.h"
#include "target.h"

namespace gradmesh::fuzz {
namespace {

/// Returns all of the text as one number.
std::optional<double> parse_number(std::string_view text) {
  Scanner scanner(text);
  const auto value = scanner.number();
  return scanner.at_end() ? value : std::nullopt;
}

void check_number(std::string_view text) {
  const auto number = parse_number(text);
  if (!number) return;
  require(std::abs(*number) <= max_coordinate, "the number is within the limit");
  require(parse_number(format_exactly(*number)) == number, "the number reads back exactly");
  const auto rounded = parse_number(format_number(*number));
  require(rounded && std::abs(*rounded - *number) <= 1e-8 * std::abs(*number),
          "the number reads back, rounded");
}

void check_opacity(std::string_view text) {
  const auto opacity = parse_opacity(text);
  require(!opacity || (*opacity >= 0 && *opacity <= 1), "the opacity is between 0 and 1");
}

/// As an attribute, and as the size that percentages are taken of.
void check_length(const std::string& text) {
  static const SvgTree document = SvgTree::parse("<svg><rect/></svg>", input_name);
  xmlNode* const svg = document.root();
  xmlNode* const rect = child_elements(svg).front();
  set_attribute(rect, "x", text);
  set_attribute(rect, "y", "50%");
  set_attribute(svg, "viewBox", text);
  accepts([&] { require(std::isfinite(read_length(rect, "x", LengthAxis::x)), "it is finite"); });
  accepts([&] { require(std::isfinite(read_length(rect, "y", LengthAxis::y)), "it is finite"); });
  accepts([&] { require(std::isfinite(read_box_length(rect, "x")), "it is finite"); });
  remove_attribute(svg, "viewBox");
  set_attribute(svg, "width", text);
  set_attribute(svg, "height", text);
  accepts([&] { read_length(rect, "y", LengthAxis::diagonal); });
}

}  // namespace

void check(std::string_view text) {
  check_number(text);
  check_opacity(text);
  check_length(std::string(text));
  parse_transform(text);
}

}  // namespace gradmesh::fuzz
