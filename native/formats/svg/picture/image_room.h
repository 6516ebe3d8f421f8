#pragma once

#include <glm/vec2.hpp>

#include "formats/svg/values/length.h"

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

}  // namespace gradmesh
