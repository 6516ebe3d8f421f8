#pragma once

#include <string_view>

#include "base/image.h"

namespace gradmesh {

/// Returns the orientation, 1 to 8, that EXIF's data states, with or without "Exif" before it; 1,
/// which is upright, where it states none or is damaged.
int exif_orientation(std::string_view exif);

/// Whether width and height change places where a picture of this orientation is brought upright.
inline bool lies_on_its_side(int orientation) { return orientation >= 5 && orientation <= 8; }

/// Returns the picture of this orientation brought upright.
RgbaImage upright(const RgbaImage& image, int orientation);

}  // namespace gradmesh
