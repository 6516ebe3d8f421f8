#pragma once

#include <string>

#include "formats/svg/read/document.h"
#include "formats/svg/read/objects.h"

namespace gradmesh {

/// An object whose mesh gradient gradmesh has written remembers its original in attributes of our
/// own namespace, ROLE being `fill` or `stroke`:
///   ROLE-original  the mesh before it was first simplified, in the coordinates of the gradient
///                  (formats/svg/write/memory.h)
///   ROLE-written   the fingerprint of the gradient as it was written, which tells whether a person
///                  has edited it since
/// They are on the object, as Inkscape gives a copy of an object a new gradient without attributes.
/// They are in the coordinates of the gradient, as those stay the same where an object is moved:
/// that changes gradientTransform alone.

/// Return the names of these attributes.
std::string original_name(PaintRole role);
std::string fingerprint_name(PaintRole role);

/// Returns the fingerprint of a gradient whose coordinates are multiples of a decimal step: the
/// step's exponent and a hash of the type, the rows and columns, all points in steps and all
/// colours in 8 bits. It stays the same where numbers are rounded, by less than half a step in
/// corners and handles. Throws InputError as gradient_patches does.
std::string gradient_fingerprint(const SvgDocument& document, const xmlNode* gradient, double step);

/// Returns true if the object has a fingerprint, and its gradient still is what that was made of.
/// Throws InputError as gradient_patches does.
bool is_as_written(const SvgDocument& document, const MeshObject& object);

}  // namespace gradmesh
