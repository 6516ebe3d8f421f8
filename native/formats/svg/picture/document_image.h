#pragma once

#include <filesystem>
#include <string>
#include <variant>

#include "formats/svg/tree/svg_tree.h"

namespace gradmesh {

/// The file of a picture that an <image> shows: its bytes, or where it lies, which may be relative
/// to the document.
using ImageFile = std::variant<std::string, std::filesystem::path>;

/// Returns true if there is an <image> with this id.
bool is_image(const SvgTree& tree, const std::string& id);

/// Returns the <image> that a shape is on: the one whose id is `image`, or, where that is empty,
/// the shape itself if it is an image; the only one of the document; or of several the uppermost
/// below the shape that reaches into the box around it, and else the lowest above. Returns null if
/// there is none at all. Throws InputError if there is no <image> with that id, and if there are
/// several of which none reaches there.
const xmlNode* image_under(const SvgTree& tree, const std::string& shape, const std::string& image);

/// Returns the id of image_under(), which it is given if it has none. Throws InputError as that
/// does, and if there is none.
std::string named_image(SvgTree& tree, const std::string& shape, const std::string& image);

/// Returns the file of image_under(). Throws InputError as that and covered_area() do, if there is
/// none, if the shape lies beside it, and if it shows something that is neither in the document nor
/// a file of this machine.
ImageFile image_file(const SvgTree& tree, const std::string& shape, const std::string& image);

}  // namespace gradmesh
