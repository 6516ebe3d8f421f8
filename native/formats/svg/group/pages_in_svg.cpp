#include "formats/svg/group/pages_in_svg.h"

#include <cmath>
#include <utility>

#include "base/error.h"
#include "formats/svg/tree/objects.h"
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

}  // namespace

PagesInSvg::PagesInSvg(SvgTree& tree, const std::vector<SvgPage>& pages, const std::string& into)
    : tree_(tree) {
  const std::vector<Affine> places = places_of(tree, pages);
  xmlNode* const group = into.empty() ? nullptr : tree.find(into);
  if (!into.empty() && (!group || (svg_name(group) != "g" && group != tree.root())))
    throw InputError("{0}: it has no layer or group with the id {1}.", tree.name(), into);
  const Affine around = group ? to_document(group) : Affine();
  if (around.determinant() == 0)
    throw InputError("{0}: the layer {1} has no size.", tree.name(), into);
  for (std::size_t n = 0; n < pages.size(); ++n)
    rooms_.push_back(group ? Room{group, around.inverse() * places[n]}
                           : Room{new_layer(pages[n], places[n]), Affine()});
}

xmlNode* PagesInSvg::new_layer(const SvgPage& page, const Affine& place) {
  xmlNode* const layer = add_child(tree_.root(), "g");
  tree_.give_id(layer, "layer");
  set_attribute(layer, "groupmode", "layer", inkscape_namespace, "inkscape");
  set_attribute(layer, "label", page.name, inkscape_namespace, "inkscape");
  if (!is_identity(place)) set_attribute(layer, "transform", transform_text(place));
  return layer;
}

std::string PagesInSvg::add(std::size_t page, NewMesh mesh) {
  const Room& room = rooms_.at(page);
  const std::string id = mesh.id;
  for (int n = 2; tree_.find(mesh.id); ++n) mesh.id = id + "-" + std::to_string(n);
  xmlNode* const object = add_object(tree_, room.group, mesh);
  if (!is_identity(room.place)) set_attribute(object, "transform", transform_text(room.place));
  return mesh.id;
}

}  // namespace gradmesh
