#pragma once

#include <filesystem>
#include <string>

#include "base/image.h"

namespace gradmesh {

/// Reads any image file that OpenImageIO reads, as 8-bit RGB: grey is spread over the channels,
/// alpha is laid over white. Throws InputError naming the file.
Image read_image(const std::filesystem::path& path);

/// Return the image as a PNG file's bytes. Throw InputError for an image without pixels.
std::string png_bytes(const Image& image);
std::string png_bytes(const RgbaImage& image);

/// Writes the image as a PNG file, wholly or not at all. Throws InputError naming the file, also
/// for an image without pixels.
void write_png(const Image& image, const std::filesystem::path& path);

}  // namespace gradmesh
