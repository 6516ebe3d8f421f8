#pragma once

#include <glm/vec2.hpp>
#include <string>

#include "base/affine.h"
#include "formats/svg/tree/svg_tree.h"
#include "geom/outline.h"

namespace gradmesh {

/// A shape on a picture, in pixels of the picture's file.
struct ShapeOnPicture {
  FilledOutline shape;
  /// The map from these pixels to the shape's user space, in which its mesh is.
  Affine to_mesh;
  /// How many pixels of the document, in its own size, such a pixel is.
  double scale;
};

/// Returns where the shape with this id lies on the picture that a document shows, whose file is
/// `pixels` large: that is where the document's one <image> is, whatever that shows, or on the
/// whole page where there is none. Throws InputError as check_can_paint does, where there are
/// several images, where the image has no size, and where there is no image and the page has no
/// size.
ShapeOnPicture shape_on_picture(const SvgTree& tree, const std::string& id, glm::dvec2 pixels);

}  // namespace gradmesh
