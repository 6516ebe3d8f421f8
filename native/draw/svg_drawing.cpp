#include "draw/svg_drawing.h"

#include <algorithm>

#include "files/base64.h"
#include "files/image_file.h"
#include "formats/text/number.h"

namespace gradmesh {
namespace {

/// The longer side of the document, in pixels.
constexpr double document_size = 900;

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  return result;
}

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + escaped(value) + "\"";
}

std::string attribute(const char* name, double value) {
  return attribute(name, format_number(value));
}

std::string painted(const Style& style) {
  std::string text = attribute("fill", style.fill);
  if (style.fill_opacity < 1) text += attribute("fill-opacity", style.fill_opacity);
  if (style.stroke == "none") return text;
  text += attribute("stroke", style.stroke) + attribute("stroke-width", style.stroke_width);
  if (style.dash > 0) text += attribute("stroke-dasharray", style.dash);
  return text;
}

std::string element(const Shape& shape) {
  const std::string start = "<path" + attribute("d", shape.path) + painted(shape.style);
  if (shape.title.empty()) return start + "/>\n";
  return start + "><title>" + escaped(shape.title) + "</title></path>\n";
}

std::string element(const Label& label) {
  static constexpr const char* anchors[] = {"start", "middle", "end"};
  return "<text" + attribute("x", label.at.x) + attribute("y", label.at.y) +
         attribute("font-size", label.size) + attribute("fill", label.color) +
         attribute("text-anchor", anchors[int(label.anchor)]) +
         (label.bold ? attribute("font-weight", "bold") : "") + ">" + escaped(label.text) +
         "</text>\n";
}

std::string element(const Layer& layer) {
  std::string text = "<g inkscape:groupmode=\"layer\"" + attribute("inkscape:label", layer.name) +
                     " stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
  for (const Shape& shape : layer.shapes) text += element(shape);
  for (const Label& label : layer.labels) text += element(label);
  return text + "</g>\n";
}

std::string box_attributes(glm::dvec2 low, glm::dvec2 high) {
  return attribute("x", low.x) + attribute("y", low.y) + attribute("width", high.x - low.x) +
         attribute("height", high.y - low.y);
}

std::string element(const PlacedImage& picture) {
  return R"(<g inkscape:groupmode="layer" inkscape:label="Picture")" +
         attribute("opacity", picture.opacity) + ">\n<image" +
         box_attributes(picture.low, picture.high) + " preserveAspectRatio=\"none\"" +
         attribute("xlink:href", "data:image/png;base64," + base64(png_bytes(picture.image))) +
         "/>\n</g>\n";
}

}  // namespace

std::string svg_text(const Drawing& drawing) {
  const glm::dvec2 low = drawing.box.low(), size = drawing.box.size();
  const double scale = document_size / std::max(size.x, size.y);
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\""
      " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"" +
      attribute("width", size.x * scale) + attribute("height", size.y * scale) +
      attribute("viewBox", format_number(low.x) + " " + format_number(low.y) + " " +
                               format_number(size.x) + " " + format_number(size.y)) +
      " font-family=\"sans-serif\">\n<title>" + escaped(drawing.title) + "</title>\n<rect" +
      box_attributes(low, drawing.box.high()) + " fill=\"white\"/>\n";
  if (drawing.picture) text += element(*drawing.picture);
  for (const Layer& layer : drawing.layers) text += element(layer);
  return text + "</svg>\n";
}

}  // namespace gradmesh
