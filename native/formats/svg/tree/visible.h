#pragma once

#include <optional>
#include <string>
#include <vector>

#include "formats/svg/tree/objects.h"
#include "formats/svg/tree/svg_tree.h"
#include "geom/box.h"
#include "geom/outline.h"

namespace gradmesh {

/// Returns the area in which the object's mesh is seen, in its user space: the inside of its own
/// shape, and of the clip paths and masks of itself and of the groups around it. All that is not
/// known here counts as seen: text and strokes, clip paths and masks that hold something else than
/// shapes or that follow the object's box, and what is clipped or masked around an object that is
/// used elsewhere too. Returns nothing if no limit of the area is known. Throws InputError at
/// geometry that cannot be read.
std::optional<VisibleArea> visible_area(const SvgTree& tree, const MeshObject& object);

/// Returns a box in the user space of a shape that a mesh gradient strokes, beyond which the stroke
/// does not reach; nothing for fills, texts, and strokes whose width is not known here.
std::optional<Box> stroke_reach(const SvgTree& tree, const MeshObject& object);

/// Returns what the shape with that id covers, or all shapes in the group with that id, in the user
/// space of the outermost <svg>, whatever their fill. Throws InputError if there is no such
/// element, or no shape with an outline in it.
std::vector<FilledOutline> covered_area(const SvgTree& tree, const std::string& id);

/// Returns true if the object is a shape with a known outline that one mesh gradient fills, so that
/// its own shape limits what is seen.
bool fills_shape(const MeshObject& object);

}  // namespace gradmesh
