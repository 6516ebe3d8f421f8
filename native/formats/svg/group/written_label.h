#pragma once

#include <functional>
#include <string>

#include "base/message.h"
#include "formats/svg/tree/objects.h"

namespace gradmesh {

/// Labels that tell of a mesh, such as "Gradient mesh: 140 handles, 80 patches", are also in our
/// attribute `label`, so that those that a person has given are told from them.

/// Takes such a label from an object and the groups around it that belong to it. Where our
/// attribute is missing, `is_ours` tells. Returns whether there was one.
bool take_written_label(const MeshObject& object,
                        const std::function<bool(const std::string&)>& is_ours);

/// Labels an element and the groups around it that belong to the same object, where a person has
/// not.
void give_written_label(xmlNode* node, const std::string& label);

/// Returns what a sentence calls an element: its label, unless gradmesh wrote that; else its id, or
/// "the picture" of an <image>, whose id no person has given.
Message called(const xmlNode* node);

}  // namespace gradmesh
