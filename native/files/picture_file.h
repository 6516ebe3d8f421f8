#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/image.h"

namespace gradmesh {

/// A picture as a person sees it: sRGB of 8 bits with opacities, upright.
struct Picture {
  RgbaImage image;
  int full_width = 0, full_height = 0;  ///< of the file, upright, before it was reduced
};

/// Reads a picture, and reduces it by area so that its longer side is at most `longest` pixels,
/// which is at least 1; it is never enlarged. Colours are brought to sRGB by the file's profile,
/// and the picture upright as EXIF says. What a file is counts, not its name: PNG and JPEG are read
/// in every build, others by OpenImageIO in one that is not portable. Throws InputError naming the
/// file, also where it ends in the middle, is damaged or is beyond a limit.
Picture read_picture(const std::filesystem::path& path, int longest);

/// Returns the picture of a PNG or JPEG file's bytes, as read_picture does. `name` is the file's in
/// messages.
Picture picture_of_bytes(std::string_view bytes, const std::string& name, int longest);

}  // namespace gradmesh
