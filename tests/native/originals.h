#pragma once

#include <algorithm>
#include <memory>

#include "reference/original.h"

/// Pictures against which tests measure meshes.
namespace gradmesh::test {

inline RgbaImage with_opacities(const Image& image) {
  RgbaImage result(image.width, image.height, 255);
  std::copy(image.samples.begin(), image.samples.end(), result.samples.begin());
  return result;
}

/// What a mesh paints in a frame, on white, as a picture that fills the frame.
inline std::shared_ptr<const Original> picture_by(const Mesh& mesh, const Frame& frame) {
  return original_of(with_opacities(paint_whole(mesh, frame).image), frame.to_pixels.inverse());
}

}  // namespace gradmesh::test
