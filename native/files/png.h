#pragma once

#include <cstdint>
#include <string>

namespace gradmesh {

/// Returns a PNG file of a picture, which has pixels: red, green and blue or, with 4 channels, also
/// opacity, pixel by pixel in rows. Throws InputError if libpng cannot make one.
std::string encode_png(int width, int height, int channels, const std::uint8_t* samples);

}  // namespace gradmesh
