#pragma once

#include <libxml/tree.h>

#include "base/affine.h"

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

}  // namespace gradmesh
