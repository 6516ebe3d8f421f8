#include "formats/svg/picture/shape_on_picture.h"

#include <glm/geometric.hpp>
#include <optional>

#include "base/error.h"
#include "formats/svg/gradient/paint_shape.h"
#include "formats/svg/picture/document_image.h"
#include "formats/svg/tree/objects.h"
#include "formats/svg/tree/visible.h"
#include "formats/svg/values/length.h"
#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

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
  if (const xmlNode* image = only_image(tree)) return image_place(tree, image, size);
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
