#include "formats/svg/tree/flat_tiles.h"

#include <algorithm>
#include <optional>

#include "base/error.h"
#include "formats/svg/tree/objects.h"
#include "formats/svg/values/color.h"
#include "formats/svg/values/shape.h"
#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

constexpr std::size_t fewest_tiles = 4;

/// Returns true if the value is 1, or says nothing.
bool is_one(const std::optional<std::string>& value) { return !value || *value == "1"; }

/// Returns the colour of a shape that is opaque and has no stroke; nothing for others.
std::optional<glm::dvec3> flat_color(const StyleSheet& styles, const xmlNode* path) {
  const auto value = [&](const char* property) { return styles.inherited(path, property); };
  if (value("stroke").value_or("none") != "none" || !is_one(value("fill-opacity")) ||
      !is_one(styles.declared(path, "opacity")) || styles.declared(path, "filter"))
    return {};
  return parse_color(value("fill").value_or("black"));
}

std::optional<FlatArea> flat_tile(const StyleSheet& styles, const xmlNode* path) {
  if (svg_name(path) != "path") return {};
  const auto color = flat_color(styles, path);
  const auto outline = color ? shape_outline(path) : std::nullopt;
  if (!outline) return {};
  const bool is_evenodd = styles.inherited(path, "fill-rule").value_or("") == "evenodd";
  FilledOutline area{*outline, is_evenodd ? FillRule::evenodd : FillRule::nonzero};
  return FlatArea{mapped(std::move(area), to_document(path)), *color};
}

/// Returns the tiles of a group; none where it holds something else too.
std::vector<FlatArea> tiles_in(const StyleSheet& styles, const xmlNode* group) try {
  const std::vector<xmlNode*> children = child_elements(group);
  if (children.size() < fewest_tiles) return {};
  std::vector<FlatArea> tiles;
  for (const xmlNode* child : children) {
    auto tile = flat_tile(styles, child);
    if (!tile) return {};
    tiles.push_back(std::move(*tile));
  }
  return tiles;
} catch (const InputError&) {
  return {};
}

/// Returns true if the element is on the page: only groups are around it, which are shown.
bool is_on_page(const SvgTree& tree, const xmlNode* group) {
  for (; group != tree.root(); group = parent_element(group))
    if (!group || svg_name(group) != "g" ||
        tree.styles().declared(group, "display").value_or("") == "none")
      return false;
  return true;
}

bool is_layer(const xmlNode* group) {
  return attribute(group, "groupmode", inkscape_namespace) == "layer";
}

bool is_empty_group(const xmlNode* node) {
  return svg_name(node) == "g" && child_elements(node).empty();
}

/// Returns the outermost group around that paints nothing else, and is no layer.
xmlNode* outermost(const SvgTree& tree, xmlNode* group) {
  for (xmlNode* around = parent_element(group); around != tree.root() && !is_layer(around);
       around = parent_element(group)) {
    const std::vector<xmlNode*> children = child_elements(around);
    const auto paints = std::ranges::count_if(children, [](auto* c) { return !is_empty_group(c); });
    if (paints > 1) break;
    group = around;
  }
  return group;
}

}  // namespace

std::vector<FlatTiles> flat_tiles(const SvgTree& tree) {
  std::vector<FlatTiles> found;
  for (xmlNode* element : elements_from(tree.root())) {
    if (svg_name(element) != "g" || !is_on_page(tree, element)) continue;
    std::vector<FlatArea> tiles = tiles_in(tree.styles(), element);
    if (!tiles.empty()) found.push_back({outermost(tree, element), std::move(tiles)});
  }
  return found;
}

}  // namespace gradmesh
