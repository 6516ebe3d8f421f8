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

std::optional<FlatArea> flat_tile(const StyleSheet& styles, const xmlNode* path) try {
  if (svg_name(path) != "path") return {};
  const auto color = flat_color(styles, path);
  const auto outline = color ? shape_outline(path) : std::nullopt;
  if (!outline) return {};
  const bool is_evenodd = styles.inherited(path, "fill-rule").value_or("") == "evenodd";
  FilledOutline area{*outline, is_evenodd ? FillRule::evenodd : FillRule::nonzero};
  return FlatArea{mapped(std::move(area), to_document(path)), *color};
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

/// Adds the runs of tiles among the children of an element.
void add_runs(const SvgTree& tree, xmlNode* parent, std::vector<FlatTiles>& found) {
  FlatTiles run;
  const std::vector<xmlNode*> children = child_elements(parent);
  const auto end_run = [&] {
    const bool is_all = run.paths.size() == children.size() && parent != tree.root();
    if (is_all) run.group = outermost(tree, parent);
    if (run.paths.size() >= fewest_tiles) found.push_back(std::move(run));
    run = {};
  };
  for (xmlNode* child : children) {
    if (auto tile = flat_tile(tree.styles(), child)) {
      run.paths.push_back(child);
      run.tiles.push_back(std::move(*tile));
    } else {
      end_run();
    }
  }
  end_run();
}

}  // namespace

std::vector<xmlNode*> elements_of(const PartOfTiles& part) {
  const std::vector<xmlNode*>& paths = part.of->paths;
  if (part.of->group && part.count() == paths.size()) return {part.of->group};
  return {paths.begin() + std::ptrdiff_t(part.begin), paths.begin() + std::ptrdiff_t(part.end)};
}

std::vector<FlatTiles> flat_tiles(const SvgTree& tree) {
  std::vector<FlatTiles> found;
  for (xmlNode* element : elements_from(tree.root()))
    if (is_on_page(tree, element)) add_runs(tree, element, found);
  return found;
}

}  // namespace gradmesh
