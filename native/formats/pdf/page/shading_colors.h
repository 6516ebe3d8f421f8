#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "formats/pdf/color/color_space.h"
#include "formats/pdf/shading/packing.h"

namespace gradmesh {

/// What the colours of a shading stand for: components of its colour space, or the parameter of a
/// function that gives them (ISO 32000-1, 8.7.4.5.5).
class ShadingColors {
 public:
  /// Throws InputError if the function does not have as many outputs as the space has components.
  ShadingColors(ColorSpace space, std::optional<Function> function);

  /// Returns false if nothing is seen of these colours.
  bool paints() const { return space_.paints(); }
  /// Returns how many numbers a colour has in the shading's data.
  std::size_t count() const { return function_ ? 1 : std::size_t(space_.components()); }
  /// Returns a colour in sRGB, 0..1.
  glm::dvec3 srgb(const Components& color) const;

 private:
  ColorSpace space_;
  std::optional<Function> function_;
};

}  // namespace gradmesh
