#include "formats/pdf/page/shading_colors.h"

#include <utility>

#include "base/error.h"

namespace gradmesh {

ShadingColors::ShadingColors(ColorSpace space, std::optional<Function> function)
    : space_(std::move(space)), function_(std::move(function)) {
  if (function_ && (function_->inputs() != 1 || function_->outputs() != space_.components()))
    throw InputError("the function of its colours does not fit its colour space");
}

glm::dvec3 ShadingColors::srgb(const Components& color) const {
  return space_.to_srgb(function_ ? (*function_)(color) : color);
}

}  // namespace gradmesh
