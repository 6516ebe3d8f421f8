#pragma once

#include <cstdint>
#include <variant>

#include "base/image.h"

namespace gradmesh {

/// A picture for a file: opaque, or with opacities by which the colours are not multiplied.
using AnyImage = std::variant<Image, RgbaImage>;

/// Returns the picture, without opacities if it is opaque.
AnyImage any_image(RgbaImage picture, bool is_opaque);

/// Returns the smallest picture found that shows what `exact` shows when programs enlarge it to the
/// same size (raster/enlarge.h): within 0.01 FLIP in the mean of the pixels that are `seen`, and
/// 0.03 in any 32 x 32 pixels. With opacities it is 0.015, over black and over white. Returns
/// `exact` itself if half as many pixels along each side do not suffice.
///
/// Samples of files are whole levels, and a level everywhere is 0.03 FLIP: rounding alone costs
/// more than half of the bound.
AnyImage smallest_picture(AnyImage exact, const Raster<std::uint8_t, 1>& seen);

}  // namespace gradmesh
