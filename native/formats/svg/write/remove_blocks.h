#pragma once

#include <libxml/tree.h>

#include <string>

#include "formats/svg/read/document.h"

namespace gradmesh {

/// Removes the blocks of a group, the mask that holds their opacities if there is one, and the
/// gradients that nothing else uses. Returns the colour that programs without meshes paint instead
/// of the blocks; empty if there is none.
std::string remove_blocks(SvgDocument& document, xmlNode* group);

}  // namespace gradmesh
