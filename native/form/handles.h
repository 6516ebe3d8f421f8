#pragma once

#include "mesh/mesh.h"

namespace gradmesh {

/// Returns the number of handles that a person finds in Inkscape's mesh tool when all of the mesh
/// is selected: a corner of each patch, two for every side that is a curve, and four for every
/// patch that is not a Coons patch; those that lie at one place count once. `surface` is the mesh
/// as a reader finds it (WrittenForm).
int count_handles(const Mesh& surface);

/// Returns the distance, in the unit of the positions, below which differences in the positions of
/// a mesh are roundings.
double rounding_of(const Mesh& mesh);

/// Returns the distance below which positions of a mesh differ by the last bits of numbers alone:
/// what must stay as it is (Mesh::is_fixed) may differ by no more.
double last_bits_of(const Mesh& mesh);

/// Returns true if a curve has its inner control points at the thirds of its chord, to within
/// `tolerance` in the unit of the positions: it can then be written as a line, which has no
/// handles.
bool is_straight(const Cubic<Value>& curve, double tolerance);

/// How many handles one object more is worth: what is selected, entered and left before a handle
/// can be dragged.
inline constexpr int handles_of_an_object = 25;

}  // namespace gradmesh
