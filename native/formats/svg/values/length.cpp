#include "formats/svg/values/length.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <optional>

#include "formats/svg/xml/node.h"
#include "formats/text/excerpt.h"
#include "formats/text/scanner.h"
#include "geom/box.h"

namespace gradmesh {
namespace {

/// Returns a viewBox, `min-x min-y width height`.
std::optional<Box> parse_view_box(std::string_view text) {
  Scanner scanner(text);
  double values[4] = {};
  for (double& value : values) {
    scanner.skip_comma();
    const auto number = scanner.number();
    if (!number) return std::nullopt;
    value = *number;
  }
  Box box;
  box.add({values[0], values[1]});
  box.add({values[0] + values[2], values[1] + values[3]});
  return box;
}

std::optional<glm::dvec2> viewport_size(const xmlNode* node) {
  const xmlNode* svg = parent_element(node);
  while (svg && svg_name(svg) != "svg") svg = parent_element(svg);
  if (!svg) return std::nullopt;
  if (const auto text = attribute(svg, "viewBox")) {
    const auto box = parse_view_box(*text);
    return box ? std::optional(box->size()) : std::nullopt;
  }
  const auto side = [&](const char* name) {
    return parse_length(attribute(svg, name).value_or(""), std::nullopt);
  };
  const auto width = side("width"), height = side("height");
  return width && height ? std::optional(glm::dvec2(*width, *height)) : std::nullopt;
}

std::optional<double> whole_length(const xmlNode* node, LengthAxis axis) {
  const auto size = viewport_size(node);
  if (!size) return std::nullopt;
  if (axis == LengthAxis::diagonal) return glm::length(*size) / std::sqrt(2.0);
  return axis == LengthAxis::x ? size->x : size->y;
}

double length_or_fail(const xmlNode* node, const char* name, const std::string& text,
                      std::optional<double> whole) {
  const auto length = parse_length(text, whole);
  if (!length) fail(node, Message("its {0} {1} is not a known length", name, excerpt(text)));
  return *length;
}

/// Returns the share of the room around a viewBox that lies before it, by preserveAspectRatio.
double share(const std::string& fit, const char* none, const char* all) {
  return fit.find(none) != fit.npos ? 0 : fit.find(all) != fit.npos ? 1 : 0.5;
}

}  // namespace

double read_length(const xmlNode* node, const char* name, LengthAxis axis) {
  const auto text = attribute(node, name);
  if (!text) return 0;
  const bool needs_whole = text->find('%') != text->npos;
  return length_or_fail(node, name, *text, needs_whole ? whole_length(node, axis) : std::nullopt);
}

double read_box_length(const xmlNode* node, const char* name) {
  const auto text = attribute(node, name);
  return text ? length_or_fail(node, name, *text, 1.0) : 0;
}

Affine to_pixels(const xmlNode* root) {
  const auto text = attribute(root, "viewBox");
  const auto box = text ? parse_view_box(*text) : std::nullopt;
  if (!box || !(box->size().x > 0 && box->size().y > 0)) return {};
  const auto side = [&](const char* name) {
    return parse_length(attribute(root, name).value_or(""), std::nullopt).value_or(0);
  };
  const glm::dvec2 size = box->size();
  glm::dvec2 page(side("width"), side("height"));
  // With one side only the document keeps its proportions; with none a unit is a pixel.
  if (!(page.x > 0)) page.x = page.y > 0 ? page.y * size.x / size.y : size.x;
  if (!(page.y > 0)) page.y = page.x * size.y / size.x;
  return fitted(size, page, attribute(root, "preserveAspectRatio").value_or("")) *
         Affine::translation(-box->low());
}

Affine fitted(glm::dvec2 size, glm::dvec2 room, const std::string& fit) {
  glm::dvec2 scale = room / size;
  if (fit.find("none") == fit.npos)
    scale = glm::dvec2(fit.find("slice") == fit.npos ? std::min(scale.x, scale.y)
                                                     : std::max(scale.x, scale.y));
  const glm::dvec2 left = room - scale * size;
  return Affine::translation(left *
                             glm::dvec2(share(fit, "xMin", "xMax"), share(fit, "YMin", "YMax"))) *
         Affine::scaling(scale);
}

std::optional<Box> page_box(const xmlNode* root) {
  if (const auto text = attribute(root, "viewBox"))
    if (const auto box = parse_view_box(*text); box && box->size().x > 0 && box->size().y > 0)
      return box;
  const auto side = [&](const char* name) {
    return parse_length(attribute(root, name).value_or(""), std::nullopt).value_or(0);
  };
  const glm::dvec2 size(side("width"), side("height"));
  if (!(size.x > 0 && size.y > 0)) return {};
  Box box;
  box.add(glm::dvec2(0.0));
  box.add(size);
  return box;
}

}  // namespace gradmesh
