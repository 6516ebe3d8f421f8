#pragma once

#include <libxml/tree.h>

#include <functional>

#include "formats/svg/read/document.h"
#include "formats/svg/read/objects.h"
#include "geom/box.h"

namespace gradmesh {

/// Adds what is painted to a group. Returns the box around it.
using AddContent = std::function<Box(xmlNode* group)>;

/// Puts a group in the place of an object that a mesh gradient paints: with the object's id,
/// transform, opacity, filter and place among its neighbours, clipped by the object's own shape or,
/// for a stroke, masked by the stroke in white (a clip path knows no strokes). `add_content` adds
/// to it what is painted instead of the gradient; if `may_be_masked` is true, a mask of the content
/// may be added to that group too. The object's other paint (its stroke, or its fill) is kept as an
/// object beside the content. The gradient is removed if nothing else uses it, and the object's
/// node is replaced.
void replace_shape(SvgDocument& document, const MeshObject& object, bool may_be_masked,
                   const AddContent& add_content);

/// Makes `mask` act inside of the box alone, in user units.
void set_mask_region(xmlNode* mask, const Box& box);

}  // namespace gradmesh
