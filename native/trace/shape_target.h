#pragma once

#include <optional>

#include "base/affine.h"
#include "base/image.h"
#include "geom/outline.h"
#include "reference/weights.h"
#include "trace/target_picture.h"

namespace gradmesh {

/// A rectangle of pixels around a shape in a picture, along axes of its own.
struct ShapeFrame {
  /// The map from these pixels to those of the picture. It turns and moves.
  Affine to_picture;
  int width, height;

  glm::dvec2 size() const { return {width, height}; }
};

/// Returns the frame around an outline, which is in pixels of the picture, whose pixels are the
/// picture's. It is a pixel wider each way, so that a mesh over it covers the outline's own pixels
/// wherever in them it is looked at.
ShapeFrame straight_frame(const Outline& outline);

/// Returns the frame that is turned to the main axes of the outline; nothing if it would be turned
/// by little, or is hardly smaller than the straight one.
std::optional<ShapeFrame> turned_frame(const Outline& outline);

/// Returns how much each of the pixels counts in a shape that is in these pixels, 0..1, row by row:
/// those that lie in it completely, as those on its outline show some of what is around it. Of a
/// shape so thin that it has none, pixels count by how much of them it covers.
std::vector<float> counted_pixels(const FilledOutline& shape, int width, int height);

/// Returns the target in a frame, of which the counted_pixels count that lie in the picture; the
/// shape is in pixels of the picture. `scale` as in point_of_pixels.
TargetPicture target_of_shape(const RgbaImage& picture, const FilledOutline& shape,
                              const ShapeFrame& frame, double scale);

/// Makes each pixel of a target count as many times more as these areas say (weights_in), which
/// `to_pixels` maps to its pixels.
void weigh(TargetPicture& target, const std::vector<WeightedArea>& areas,
           const Affine& to_pixels = {});

}  // namespace gradmesh
