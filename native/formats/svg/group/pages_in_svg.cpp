#include "formats/svg/group/pages_in_svg.h"

#include <cmath>
#include <utility>

#include "base/error.h"
#include "formats/svg/tree/objects.h"
#include "formats/svg/tree/unused.h"
#include "formats/svg/values/length.h"
#include "formats/svg/values/transform.h"
#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

/// Returns the upper left corners of the document's pages, in units of its outermost <svg>.
std::vector<glm::dvec2> page_corners(const SvgTree& tree) {
  std::vector<glm::dvec2> corners;
  for (const xmlNode* element : elements_from(tree.root()))
    if (element->ns && view(element->ns->href) == inkscape_namespace &&
        view(element->name) == "page")
      corners.push_back(
          {read_length(element, "x", LengthAxis::x), read_length(element, "y", LengthAxis::y)});
  return corners;
}

/// Returns where pages lie: the maps from their pixels to units of the outermost <svg>.
std::vector<Affine> places_of(const SvgTree& tree, const std::vector<SvgPage>& pages) {
  const Affine to_units = {to_pixels(tree.root()).inverse().linear, glm::dvec2(0.0)};
  const std::vector<glm::dvec2> corners = page_corners(tree);
  const auto page = page_box(tree.root());
  const glm::dvec2 first = page ? page->low() : glm::dvec2(0.0);
  std::vector<Affine> places;
  double beside = 0;
  for (const SvgPage& each : pages) {
    const std::size_t place = std::size_t(each.number - 1);
    const glm::dvec2 corner =
        place < corners.size() ? corners[place] : first + to_units.point({beside, 0});
    places.push_back(Affine::translation(corner) * to_units);
    beside += each.width + page_gap;
  }
  return places;
}

bool is_identity(const Affine& map) {
  constexpr double rounding = 1e-9;
  const auto [linear, offset] = map;
  return std::abs(linear[0].x - 1) < rounding && std::abs(linear[1].y - 1) < rounding &&
         std::abs(linear[0].y) < rounding && std::abs(linear[1].x) < rounding &&
         std::abs(offset.x) < rounding && std::abs(offset.y) < rounding;
}

bool is_within(const xmlNode* node, const xmlNode* group) {
  while (node && node != group) node = parent_element(node);
  return node == group;
}

}  // namespace

PagesInSvg::PagesInSvg(SvgTree& tree, const std::vector<SvgPage>& pages, const std::string& into)
    : tree_(tree), pages_(pages), places_(places_of(tree, pages)) {
  xmlNode* const group = into.empty() ? nullptr : tree.find(into);
  if (!into.empty() && (!group || (svg_name(group) != "g" && group != tree.root())))
    throw InputError("{0}: it has no layer or group with the id {1}.", tree.name(), into);
  if (group && to_document(group).determinant() == 0)
    throw InputError("{0}: the layer {1} has no size.", tree.name(), into);
  groups_.assign(pages.size(), group);
}

xmlNode* PagesInSvg::layer(std::size_t page) {
  xmlNode*& layer = groups_.at(page);
  if (layer) return layer;
  layer = add_child(tree_.root(), "g");
  tree_.give_id(layer, "layer");
  set_attribute(layer, "groupmode", "layer", inkscape_namespace, "inkscape");
  set_attribute(layer, "label", pages_[page].name, inkscape_namespace, "inkscape");
  if (!is_identity(places_[page])) set_attribute(layer, "transform", transform_text(places_[page]));
  return layer;
}

xmlNode* PagesInSvg::add_to(xmlNode* group, std::size_t page, NewMesh& mesh) {
  const std::string id = mesh.id;
  for (int n = 2; tree_.find(mesh.id); ++n) mesh.id = id + "-" + std::to_string(n);
  xmlNode* const object = add_object(tree_, group, mesh);
  const Affine place = to_document(group).inverse() * places_.at(page);
  const bool is_itself = attribute(object, "id") == mesh.id;
  const Affine map = is_itself ? place * mesh.to_page : place;
  if (!is_identity(map)) set_attribute(object, "transform", transform_text(map));
  return object;
}

std::string PagesInSvg::add(std::size_t page, NewMesh mesh) {
  add_to(mixed_.within(tree_, layer(page), mesh.groups), page, mesh);
  return mesh.id;
}

std::string PagesInSvg::add_instead(const PartOfTiles& tiles, std::size_t page, NewMesh mesh) {
  const std::vector<xmlNode*> elements = elements_of(tiles);
  xmlNode* const around = parent_element(elements.front());
  if (to_document(around).determinant() == 0) return add(page, std::move(mesh));
  xmlAddPrevSibling(elements.front(), add_to(around, page, mesh));
  // What objects go into may lie in what is removed.
  for (xmlNode* const element : elements)
    for (xmlNode*& into : groups_)
      if (into && is_within(into, element)) into = around;
  remove_with_clips(tree_, elements);
  return mesh.id;
}

}  // namespace gradmesh
