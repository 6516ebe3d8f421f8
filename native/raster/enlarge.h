#pragma once

#include <cstdint>

#include "base/image.h"

namespace gradmesh {

/// Return the picture with colours multiplied by opacities, rounded.
Image multiplied(Image picture);
RgbaImage multiplied(RgbaImage picture);

/// Returns rows [rows.y0, rows.y1) of a picture as browsers, Inkscape and librsvg show it with more
/// pixels, `width` x `height` in all: colours change evenly from the middle of one pixel to that of
/// the next, go on beyond the outermost ones, and are rounded down. Colours are multiplied() before
/// and after. The picture has two pixels or more along each side.
template <int Channels>
Raster<std::uint8_t, Channels> enlarged(const Raster<std::uint8_t, Channels>& picture, int width,
                                        int height, Window rows);

/// Returns the picture of `width` x `height` pixels, two or more along each side and no more than
/// `picture` has, that is near to it when enlarged: by least squares over its samples, which are
/// whole numbers. Colours are not multiplied by opacities in either.
template <int Channels>
Raster<std::uint8_t, Channels> reduced(const Raster<std::uint8_t, Channels>& picture, int width,
                                       int height);

}  // namespace gradmesh
