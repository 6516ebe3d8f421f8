#pragma once

#include <libxml/tree.h>

#include <functional>

#include "formats/svg/tree/objects.h"
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
void replace_shape(SvgTree& tree, const MeshObject& object, bool may_be_masked,
                   const AddContent& add_content);

/// Gives the element the place and the size of the box, with so many digits.
void set_box(xmlNode* node, const Box& box, int digits);

/// Makes `mask` act inside of the box alone, in user units.
void set_mask_region(xmlNode* mask, const Box& box);

/// Throws InputError if restore_shape cannot work: the shape is gone, or the object's fill and
/// stroke are both groups of blocks.
void check_restorable(SvgTree& tree, const MeshObject& group);

/// Replaces a group of blocks by the object that it was made of, with all that replace_shape had
/// moved to the group: shape, id, transform, opacity, effects, and the other paint. The object's
/// mesh paint names an empty mesh gradient (userSpaceOnUse), whose patches the caller writes. The
/// group, its blocks and what only they used are removed. Throws as check_restorable does, before
/// anything is changed. Returns the object.
MeshObject restore_shape(SvgTree& tree, const MeshObject& group);

}  // namespace gradmesh
