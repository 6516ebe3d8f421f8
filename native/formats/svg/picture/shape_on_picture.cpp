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

namespace gradmesh {
namespace {

/// Returns the map from pixels of a picture, which is `size` large, to units of the outermost
/// <svg>.
Affine picture_place(const SvgTree& tree, const xmlNode* image, glm::dvec2 size) {
  if (image) return to_document(image) * picture_in_image(image, size).place;
  const std::optional<Box> page = page_box(tree.root());
  if (!page) throw InputError("{0}: it has neither a picture nor a page with a size.", tree.name());
  return Affine::translation(page->low()) * Affine::scaling(page->size() / size);
}

}  // namespace

ShapeOnPicture shape_on_picture(const SvgTree& tree, const std::string& id,
                                const std::string& image, glm::dvec2 pixels) {
  const Affine place = picture_place(tree, image_under(tree, id, image), pixels);
  const Affine to_page = to_pixels(tree.root()) * place;
  const double scale = glm::length(to_page.linear[0]);
  if (is_image(tree, id)) {
    const xmlNode* const covered = tree.find(id);
    const Affine to_user = picture_in_image(covered, pixels).place;
    const Box seen = seen_of_image(tree, covered, pixels);
    return {{mapped(rectangle(seen.low(), seen.high()), to_user.inverse())}, to_user, scale};
  }
  const Affine to_document = user_to_document(tree, id);
  return {mapped(covered_area(tree, id).front(), place.inverse()), to_document.inverse() * place,
          scale};
}

}  // namespace gradmesh
