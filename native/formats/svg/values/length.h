#pragma once

#include <libxml/tree.h>

namespace gradmesh {

/// What a percentage is taken of: the viewport's width, its height, or its mean for radii.
enum class LengthAxis { x, y, diagonal };

/// A length attribute in the element's user units, 0 where it is absent. Percentages are of the
/// nearest <svg> around the element, by its viewBox or else its width and height. Throws
/// InputError if it is no number with a plain unit, or a percentage of an unknown size.
double read_length(const xmlNode* node, const char* name, LengthAxis axis);

/// The same with percentages as fractions, as in units of an object's bounding box.
double read_box_length(const xmlNode* node, const char* name);

}  // namespace gradmesh
