#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "base/affine.h"
#include "formats/svg/tree/svg_tree.h"
#include "geom/outline.h"

namespace gradmesh {

/// A shape on a picture, in pixels of the picture's file.
struct ShapeOnPicture {
  FilledOutline shape;
  /// Open lines along which lines of its mesh are to run, which may reach beyond it.
  std::vector<std::vector<glm::dvec2>> guides = {};
  /// The map from these pixels to the shape's user space, in which its mesh is; and from units of
  /// the outermost <svg> to these pixels.
  Affine to_mesh = {}, from_document = {};
  /// How many pixels of the document, in its own size, such a pixel is.
  double scale = 1;
};

/// Returns where a shape, and the lines of these ids, lie on the picture of the <image> that the
/// shape is on (image_under), whose file is `pixels` large, or on the whole page where the document
/// has no image. If `id` is that of an <image>, the shape is the rectangle of cover_image(). Throws
/// InputError as user_to_document and image_under do, where a guide is no path, polyline or line,
/// where the image has no size or no picture is seen of it, and where there is no image and the
/// page has no size.
ShapeOnPicture shape_on_picture(const SvgTree& tree, const std::string& id,
                                const std::string& image, const std::vector<std::string>& guides,
                                glm::dvec2 pixels);

}  // namespace gradmesh
