#pragma once

#include <filesystem>
#include <string>
#include <variant>

#include "formats/svg/tree/svg_tree.h"

namespace gradmesh {

/// The file of a picture that an <image> shows: its bytes, or where it lies, which may be relative
/// to the document.
using ImageFile = std::variant<std::string, std::filesystem::path>;

/// Returns the one <image> of a document; null if there is none. Throws InputError if there are
/// several.
const xmlNode* only_image(const SvgTree& tree);

/// Returns the file of the one <image> of a document. Throws InputError if there is none, or
/// several, and if it shows something that is neither in the document nor a file of this machine.
ImageFile image_file(const SvgTree& tree);

}  // namespace gradmesh
