#include "formats/svg/picture/shape_on_picture.h"

#include <glm/geometric.hpp>
#include <optional>

#include "base/error.h"
#include "formats/svg/gradient/paint_shape.h"
#include "formats/svg/picture/document_image.h"
#include "formats/svg/picture/image_cover.h"
#include "formats/svg/tree/objects.h"
#include "formats/svg/tree/visible.h"
#include "formats/svg/values/length.h"
#include "formats/svg/values/shape.h"
#include "formats/svg/xml/node.h"
#include "formats/text/excerpt.h"

namespace gradmesh {
namespace {

/// Returns the map from pixels of a picture, which is `size` large, to units of the outermost
/// <svg>.
Affine picture_place(const SvgTree& tree, const xmlNode* image, glm::dvec2 size) {
  if (image) return to_document(image) * picture_in_image(tree, image, size).place;
  const std::optional<Box> page = page_box(tree.root());
  if (!page) throw InputError("{0}: it has neither a picture nor a page with a size.", tree.name());
  return Affine::translation(page->low()) * Affine::scaling(page->size() / size);
}

/// Returns the lines of an element, in units of the outermost <svg>.
Outline lines_of(const SvgTree& tree, const std::string& id) {
  const xmlNode* const node = tree.find(id);
  if (!node) throw InputError("{0}: there is no object with the id {1}.", tree.name(), excerpt(id));
  const std::string_view name = svg_name(node);
  if (name == "line") {
    const auto at = [node](const char* x, const char* y) {
      return glm::dvec2(read_length(node, x, LengthAxis::x), read_length(node, y, LengthAxis::y));
    };
    return mapped(Outline{{at("x1", "y1"), at("x2", "y2")}}, to_document(node));
  }
  if (name != "path" && name != "polyline")
    throw InputError("{0}: {1} is no path that lines of a mesh could follow.", tree.name(),
                     excerpt(id));
  return mapped(*shape_outline(node), to_document(node));
}

ShapeOnPicture without_guides(const SvgTree& tree, const std::string& id, const Affine& place,
                              glm::dvec2 pixels) {
  ShapeOnPicture on;
  on.scale = glm::length((to_pixels(tree.root()) * place).linear[0]);
  on.from_document = place.inverse();
  if (is_image(tree, id)) {
    const xmlNode* const image = tree.find(id);
    const Box seen = seen_of_image(tree, image, pixels);
    on.to_mesh = picture_in_image(tree, image, pixels).place;
    on.shape = {mapped(rectangle(seen.low(), seen.high()), on.to_mesh.inverse())};
  } else {
    on.to_mesh = user_to_document(tree, id).inverse() * place;
    on.shape = mapped(covered_area(tree, id).front(), on.from_document);
  }
  return on;
}

}  // namespace

ShapeOnPicture shape_on_picture(const SvgTree& tree, const std::string& id,
                                const std::string& image, const std::vector<std::string>& guides,
                                glm::dvec2 pixels) {
  const Affine place = picture_place(tree, image_under(tree, id, image), pixels);
  ShapeOnPicture on = without_guides(tree, id, place, pixels);
  for (const std::string& guide : guides)
    for (std::vector<glm::dvec2>& line : mapped(lines_of(tree, guide), on.from_document))
      on.guides.push_back(std::move(line));
  return on;
}

}  // namespace gradmesh
