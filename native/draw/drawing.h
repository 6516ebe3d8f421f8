#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "geom/box.h"

namespace gradmesh {

/// How a shape is painted; lengths in the drawing's units, colours as in SVG.
struct Style {
  std::string fill = "none";
  double fill_opacity = 1;
  std::string stroke = "none";
  double stroke_width = 0;
  /// Length of dashes and gaps; 0 for a solid line.
  double dash = 0;
};

struct Shape {
  /// SVG path data.
  std::string path;
  Style style;
  /// Text that a browser shows when one points at the shape; may be empty.
  std::string title;
};

enum class Anchor { start, middle, end };

struct Label {
  std::string text;
  /// Point on the baseline.
  glm::dvec2 at;
  double size;
  std::string color;
  Anchor anchor = Anchor::start;
  bool bold = false;
};

/// A layer as Inkscape has them. Labels lie above shapes.
struct Layer {
  std::string name;
  std::vector<Shape> shapes;
  std::vector<Label> labels;
};

/// An image in the box from `low` to `high`.
struct PlacedImage {
  Image image;
  glm::dvec2 low, high;
  double opacity = 1;
};

/// Layers from bottom to top, over a picture, over white. y points down.
struct Drawing {
  std::string title;
  /// The area that is shown.
  Box box;
  std::optional<PlacedImage> picture;
  std::vector<Layer> layers;
};

}  // namespace gradmesh
