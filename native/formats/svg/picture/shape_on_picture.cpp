#include "formats/svg/picture/shape_on_picture.h"

#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "base/error.h"
#include "formats/svg/gradient/paint_shape.h"
#include "formats/svg/tree/objects.h"
#include "formats/svg/tree/visible.h"
#include "formats/svg/values/length.h"
#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

void collect_images(const xmlNode* node, std::vector<const xmlNode*>& images) {
  if (svg_name(node) == "image") images.push_back(node);
  for (const xmlNode* child : child_elements(node)) collect_images(child, images);
}

Affine image_place(const SvgTree& tree, const xmlNode* image, glm::dvec2 size) {
  glm::dvec2 room(read_length(image, "width", LengthAxis::x),
                  read_length(image, "height", LengthAxis::y));
  // What is not said follows from the picture.
  if (!attribute(image, "width"))
    room.x = attribute(image, "height") ? room.y * size.x / size.y : size.x;
  if (!attribute(image, "height")) room.y = room.x * size.y / size.x;
  const Affine to_document = gradmesh::to_document(image);
  if (!(room.x > 0 && room.y > 0) || to_document.determinant() == 0)
    throw InputError("{0}: its picture has no size.", tree.name());
  return to_document *
         Affine::translation(
             {read_length(image, "x", LengthAxis::x), read_length(image, "y", LengthAxis::y)}) *
         fitted(size, room, attribute(image, "preserveAspectRatio").value_or(""));
}

/// Returns the map from pixels of a picture, which is `size` large, to units of the outermost
/// <svg>.
Affine picture_place(const SvgTree& tree, glm::dvec2 size) {
  std::vector<const xmlNode*> images;
  collect_images(tree.root(), images);
  if (images.size() > 1)
    throw InputError("{0}: it holds {1} pictures; leave the one that the outline lies on.",
                     tree.name(), images.size());
  if (!images.empty()) return image_place(tree, images.front(), size);
  const std::optional<Box> page = page_box(tree.root());
  if (!page) throw InputError("{0}: it has neither a picture nor a page with a size.", tree.name());
  return Affine::translation(page->low()) * Affine::scaling(page->size() / size);
}

}  // namespace

ShapeOnPicture shape_on_picture(const SvgTree& tree, const std::string& id, glm::dvec2 pixels) {
  const Affine to_document = user_to_document(tree, id);
  const Affine place = picture_place(tree, pixels);
  const Affine to_page = to_pixels(tree.root()) * place;
  return {mapped(covered_area(tree, id).front(), place.inverse()), to_document.inverse() * place,
          glm::length(to_page.linear[0])};
}

}  // namespace gradmesh
