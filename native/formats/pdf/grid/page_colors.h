#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "formats/pdf/grid/page_patch.h"
#include "geom/box.h"

namespace gradmesh {

/// What colours patches paint on a page.
class PageColors {
 public:
  /// Takes at least one patch.
  explicit PageColors(const std::vector<PagePatch>& patches);

  /// Returns the colour at a place: that of the patch there or, where there is none, that at the
  /// nearest place of one whose box is at most half a point away. Far away from all of them it is
  /// that of the first patch.
  glm::dvec4 at(glm::dvec2 place) const;

 private:
  struct Painted {
    Patch patch;
    Box box;
  };
  std::vector<Painted> patches_;
};

}  // namespace gradmesh
