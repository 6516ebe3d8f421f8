#pragma once

#include <libxml/tree.h>

#include <glm/vec4.hpp>
#include <map>
#include <string>
#include <string_view>

#include "formats/svg/tree/objects.h"
#include "formats/svg/tree/svg_tree.h"

namespace gradmesh {

/// A colour as it stands in a document, such as `hsl(120, 100, 45.9)`.
struct ColorText {
  std::string text;
  /// (r, g, b, opacity) of the text alone.
  glm::dvec4 color;

  /// Returns the stop-opacity with which the text has this opacity, which is not above the text's.
  double opacity_beside(double opacity) const;
};

/// The texts of an object's colours that hexadecimal digits could not give back as they stood
/// (own_color_text). Colours that nobody has changed are written with them again.
class ColorTexts {
 public:
  bool is_empty() const { return texts_.empty(); }
  /// Adds the text of a stop's colour if it is of that kind.
  void add(std::string_view text);
  /// Adds those of a list().
  void add_list(std::string_view list);
  /// Returns the texts, each once, separated by semicolons.
  std::string list() const;
  /// Returns the text whose colour is nearest, and no farther from this one in a channel than 8
  /// bits would round it; null if there is none. A text whose opacity is below this one does not
  /// count.
  const ColorText* find(const glm::dvec4& color) const;

 private:
  /// By red.
  std::multimap<double, ColorText> texts_;
};

/// Returns the texts of an object's mesh: those in its gradient, or in the gradients of its blocks,
/// and those that the object remembers, as attributes of our own namespace:
///   ROLE-colors  on an object with one mesh gradient, ROLE being `fill` or `stroke`
///   colors       on a group of blocks
/// They are in the order of their colours, separated by semicolons, and are those of the mesh
/// before it was first simplified too, whose other colours are in its memory.
ColorTexts color_texts(const SvgTree& tree, const MeshObject& object);
/// Makes an object with one mesh gradient, or a group of blocks, remember the texts; nothing if
/// there are none.
void remember_color_texts(const MeshObject& object, const ColorTexts& texts);

}  // namespace gradmesh
