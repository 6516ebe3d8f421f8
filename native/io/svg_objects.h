#pragma once

#include <libxml/tree.h>

#include <string>
#include <vector>

#include "base/affine.h"
#include "io/svg_document.h"

namespace gradmesh {

enum class PaintRole { fill, stroke };

/// A shape or text whose fill or stroke is a mesh gradient. The nodes belong to the document.
struct MeshObject {
  xmlNode* node = nullptr;
  std::string id;
  PaintRole role = PaintRole::fill;
  /// The meshgradient that the paint names; its patches may be another's, through href.
  xmlNode* gradient = nullptr;
};

/// Every object painted by a mesh gradient, in document order, fill before stroke. The paint may
/// come from a style, a rule, an attribute or a group around the object. What only serves others
/// (in <defs>, <clipPath>, <mask>, <symbol>, <pattern>, <marker>) is left out, as are lines' fills,
/// which paint nothing. An object without an id gets one.
std::vector<MeshObject> mesh_objects(SvgDocument& document);

/// From the object's user space to that of the outermost <svg>: the product of the `transform`
/// attributes of the element and of all around it; viewBox and nested viewports do not count.
/// Throws InputError at a malformed one.
Affine to_document(const MeshObject& object);

}  // namespace gradmesh
