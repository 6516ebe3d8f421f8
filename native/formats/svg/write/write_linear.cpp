#include "formats/svg/write/write_linear.h"

#include <glm/vec3.hpp>
#include <string>

#include "formats/svg/read/paint.h"
#include "formats/svg/values/color.h"
#include "formats/svg/xml/edit.h"
#include "formats/svg/xml/node.h"
#include "formats/text/number.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

/// Adds a linear gradient with these colours. Returns its id.
std::string add_gradient(SvgDocument& document, const std::string& prefix,
                         const LinearColors& colors) {
  xmlNode* gradient = add_child(document.defs(), "linearGradient");
  const std::string id = document.give_id(gradient, prefix);
  set_attribute(gradient, "gradientUnits", "userSpaceOnUse");
  Box box;
  box.add(colors.start);
  box.add(colors.end);
  const int digits = digits_within(box);
  set_attribute(gradient, "x1", format_number(colors.start.x, digits));
  set_attribute(gradient, "y1", format_number(colors.start.y, digits));
  set_attribute(gradient, "x2", format_number(colors.end.x, digits));
  set_attribute(gradient, "y2", format_number(colors.end.y, digits));
  for (const auto& [place, color] : colors.stops) {
    xmlNode* stop = add_child(gradient, "stop");
    set_attribute(stop, "offset", format_number(place));
    set_attribute(stop, "style", "stop-color:" + color_text(color) + ";stop-opacity:1");
  }
  return id;
}

}  // namespace

void write_linear(SvgDocument& document, const MeshObject& object, const LinearColors& colors) {
  const std::string paint = object.role == PaintRole::fill ? "fill" : "stroke";
  const std::string inherited =
      document.styles().inherited(object.node, paint + "-opacity").value_or("1");
  const double opacity = colors.stops.front().color.a * parse_opacity(inherited).value_or(1);
  set_style(object.node, paint,
            colors.stops.size() == 1
                ? color_text(colors.stops.front().color)
                : "url(#" + add_gradient(document, object.id + "-gradient", colors) + ")");
  set_style(object.node, paint + "-opacity", format_number(opacity, 6));
  remove_if_unused(document, attribute(object.gradient, "id").value_or(""));
}

}  // namespace gradmesh
