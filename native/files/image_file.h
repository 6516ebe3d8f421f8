#pragma once

#include <filesystem>
#include <string>

#include "base/image.h"

namespace gradmesh {

/// Any image file that OpenImageIO reads, as 8-bit RGB: grey is spread over the channels, alpha is
/// laid over white. Throws InputError naming the file.
Image read_image(const std::filesystem::path& path);

/// The image as a PNG file's bytes. Throws InputError for an image without pixels.
std::string png_bytes(const Image& image);

/// Writes the whole file or leaves what was there. Throws InputError naming the file, also for an
/// image without pixels.
void write_png(const Image& image, const std::filesystem::path& path);

}  // namespace gradmesh
