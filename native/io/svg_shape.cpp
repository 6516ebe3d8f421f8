#include "io/svg_shape.h"

#include <string>

#include "io/svg_length.h"
#include "io/svg_scanner.h"
#include "io/xml_node.h"

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

Box points_box(const xmlNode* shape) {
  const std::string points = attribute(shape, "points").value_or("");
  Box box;
  Scanner scanner(points);
  while (!scanner.at_end()) {
    scanner.skip_comma();
    const auto x = scanner.number();
    scanner.skip_comma();
    const auto y = scanner.number();
    if (!x || !y) fail(shape, "its points " + excerpt(points) + " are malformed");
    box.add({*x, *y});
  }
  return box;
}

Box path_element_box(const xmlNode* path) {
  const std::string data = attribute(path, "d").value_or("");
  const auto box = path_box(data);
  if (!box) fail(path, "its path data " + excerpt(data) + " are malformed");
  return *box;
}

}  // namespace

std::optional<Box> shape_box(const xmlNode* shape) {
  const std::string_view name = svg_name(shape);
  if (name == "path") return path_element_box(shape);
  if (name == "rect") return rect_box(shape);
  if (name == "circle")
    return ellipse_box(shape, glm::dvec2(read_length(shape, "r", LengthAxis::diagonal)));
  if (name == "ellipse") return ellipse_box(shape, ellipse_radii(shape));
  if (name == "line") return line_box(shape);
  if (name == "polyline" || name == "polygon") return points_box(shape);
  return std::nullopt;
}

}  // namespace gradmesh
