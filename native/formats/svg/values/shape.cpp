#include "formats/svg/values/shape.h"

#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <string>

#include "formats/svg/values/length.h"
#include "formats/svg/xml/node.h"
#include "formats/text/excerpt.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

double x_length(const xmlNode* node, const char* name) {
  return read_length(node, name, LengthAxis::x);
}

double y_length(const xmlNode* node, const char* name) {
  return read_length(node, name, LengthAxis::y);
}

Box rect_box(const xmlNode* rect) {
  const glm::dvec2 corner{x_length(rect, "x"), y_length(rect, "y")};
  Box box;
  box.add(corner);
  box.add(corner + glm::dvec2(x_length(rect, "width"), y_length(rect, "height")));
  return box;
}

Box ellipse_box(const xmlNode* ellipse, glm::dvec2 radii) {
  const glm::dvec2 center{x_length(ellipse, "cx"), y_length(ellipse, "cy")};
  Box box;
  box.add(center - radii);
  box.add(center + radii);
  return box;
}

glm::dvec2 ellipse_radii(const xmlNode* ellipse) {
  const auto given = [&](const char* name) {
    return attribute(ellipse, name).value_or("auto") != "auto";
  };
  const double rx = given("rx") ? x_length(ellipse, "rx") : 0;
  const double ry = given("ry") ? y_length(ellipse, "ry") : 0;
  // SVG 2: one radius alone holds for both.
  return {given("rx") ? rx : ry, given("ry") ? ry : rx};
}

Box line_box(const xmlNode* line) {
  Box box;
  box.add({x_length(line, "x1"), y_length(line, "y1")});
  box.add({x_length(line, "x2"), y_length(line, "y2")});
  return box;
}

std::vector<glm::dvec2> read_points(const xmlNode* shape) {
  const std::string points = attribute(shape, "points").value_or("");
  std::vector<glm::dvec2> list;
  Scanner scanner(points);
  while (!scanner.at_end()) {
    scanner.skip_comma();
    const auto x = scanner.number();
    scanner.skip_comma();
    const auto y = scanner.number();
    if (!x || !y) fail(shape, Message("its points {0} are malformed", excerpt(points)));
    list.emplace_back(*x, *y);
  }
  return list;
}

Box points_box(const xmlNode* shape) {
  Box box;
  for (const glm::dvec2 p : read_points(shape)) box.add(p);
  return box;
}

/// Returns the result of `read` for the path's data.
template <class Read>
auto read_path(const xmlNode* path, const Read& read) {
  const std::string data = attribute(path, "d").value_or("");
  auto result = read(data);
  if (!result) fail(path, Message("its path data {0} are malformed", excerpt(data)));
  return *std::move(result);
}

/// Appends a quarter of an ellipse that begins at `angle`, with its first point.
void add_quarter(std::vector<glm::dvec2>& polygon, glm::dvec2 center, glm::dvec2 radii,
                 double angle) {
  for (int i = 0; i <= outline_steps; ++i) {
    const double a = angle + std::numbers::pi / 2 * i / outline_steps;
    polygon.push_back(center + radii * glm::dvec2(std::cos(a), std::sin(a)));
  }
}

/// Returns a rectangle with corners rounded by `radii`; an ellipse if these are half its size.
Outline rounded_outline(const Box& box, glm::dvec2 radii) {
  const glm::dvec2 r = glm::min(glm::abs(radii), box.size() / 2.0);
  const glm::dvec2 low = box.low() + r, high = box.high() - r;
  std::vector<glm::dvec2> polygon;
  add_quarter(polygon, high, r, 0);
  add_quarter(polygon, {low.x, high.y}, r, std::numbers::pi / 2);
  add_quarter(polygon, low, r, std::numbers::pi);
  add_quarter(polygon, {high.x, low.y}, r, 3 * std::numbers::pi / 2);
  return {polygon};
}

}  // namespace

std::optional<Box> shape_box(const xmlNode* shape) {
  const std::string_view name = svg_name(shape);
  if (name == "path") return read_path(shape, path_box);
  if (name == "rect") return rect_box(shape);
  if (name == "circle")
    return ellipse_box(shape, glm::dvec2(read_length(shape, "r", LengthAxis::diagonal)));
  if (name == "ellipse") return ellipse_box(shape, ellipse_radii(shape));
  if (name == "line") return line_box(shape);
  if (name == "polyline" || name == "polygon") return points_box(shape);
  return std::nullopt;
}

std::optional<Outline> shape_outline(const xmlNode* shape) {
  const std::string_view name = svg_name(shape);
  if (name == "path") return read_path(shape, path_outline);
  if (name == "polyline" || name == "polygon") return Outline{read_points(shape)};
  if (name != "rect" && name != "circle" && name != "ellipse") return std::nullopt;
  const auto box = shape_box(shape);
  return rounded_outline(*box, name == "rect" ? ellipse_radii(shape) : box->size() / 2.0);
}

}  // namespace gradmesh
