#pragma once

#include <glm/vec2.hpp>
#include <string>

#include "base/affine.h"
#include "formats/svg/tree/svg_tree.h"
#include "formats/svg/values/length.h"
#include "geom/box.h"

namespace gradmesh {

/// The rectangle that an <image> is to fill, in its user space. A size that is not said is 0.
struct ImageRoom {
  glm::dvec2 corner, size;
};

inline ImageRoom image_room(const xmlNode* image) {
  return {
      {read_length(image, "x", LengthAxis::x), read_length(image, "y", LengthAxis::y)},
      {read_length(image, "width", LengthAxis::x), read_length(image, "height", LengthAxis::y)}};
}

/// How an <image> shows its picture, in its user space.
struct PictureInImage {
  /// The map from pixels of the picture.
  Affine place;
  /// The room that the image has, beyond which none of the picture is seen.
  Box room;
};

/// Returns how an <image> shows a picture that is `pixels` large. Throws InputError if the image
/// has no size.
PictureInImage picture_in_image(const SvgTree& tree, const xmlNode* image, glm::dvec2 pixels);

/// Returns the box around what is seen of an image's picture, which is `pixels` large, in the
/// image's user space: in its room, and in the clip paths and masks around it that visible_area()
/// knows. Throws InputError if the image has no size, and if nothing is seen.
Box seen_of_image(const SvgTree& tree, const xmlNode* image, glm::dvec2 pixels);

/// Puts a rectangle directly above the image with this id, over seen_of_image(), with the image's
/// transform, clip path, mask and opacity, and returns its id. Throws as seen_of_image does.
std::string cover_image(SvgTree& tree, const std::string& id, glm::dvec2 pixels);

}  // namespace gradmesh
