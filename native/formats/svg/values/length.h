#pragma once

#include <libxml/tree.h>

#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "base/affine.h"
#include "geom/box.h"

namespace gradmesh {

/// The size that a percentage refers to: the viewport's width, its height, or their root mean
/// square for radii.
enum class LengthAxis { x, y, diagonal };

/// Returns a length attribute in the element's user units, 0 if it is absent. Percentages are of
/// the nearest <svg> around the element, by its viewBox or else its width and height. Throws
/// InputError if the value is no number with a plain unit, or is a percentage of an unknown size.
double read_length(const xmlNode* node, const char* name, LengthAxis axis);

/// Returns a length attribute with percentages as fractions, as in units of an object's bounding
/// box.
double read_box_length(const xmlNode* node, const char* name);

/// Returns the map from units of the outermost <svg> to pixels of the document as it is shown in
/// its own size; a unit is a pixel if that is not known.
Affine to_pixels(const xmlNode* root);

/// Returns the map from what is `size` large to the room from (0, 0) in which it is shown, as a
/// preserveAspectRatio says.
Affine fitted(glm::dvec2 size, glm::dvec2 room, const std::string& preserve_aspect_ratio);

/// Returns the page in units of the outermost <svg>; nothing if it has no size.
std::optional<Box> page_box(const xmlNode* root);

}  // namespace gradmesh
