#pragma once

#include <string>
#include <vector>

#include "mesh/mesh.h"

namespace gradmesh {

/// Returns every invariant of the mesh that is broken, as "name: where"; none if the mesh is sound.
/// An example is "twin: halfedge 12". The names:
///   indices    every reference points to an element that is alive
///   face       four leaves form the loop of a face; next and prev are inverse
///   twin       twins name each other, never themselves, and run between the same points
///   leaf       leaves have a face; parents have none
///   children   children alternate bar, stem, bar; bars fill [0, 1]; stems lie between them
///   bar        bars have no twin, handles or children, and start where their interval says
///   handles    each curve has two, shared by its twins
///   point      a point's half-edge starts there and is no bar; the four corners agree on points
///   junction   a T-junction has exactly one stem and lies on its parent
///   color      a colour that is not a junction's own is the parent's
///   cycle      no curve depends on itself (dependence.h)
///   finite     all numbers are finite
///   count      the number of faces is kept right
std::vector<std::string> validate(const Mesh& mesh);

}  // namespace gradmesh
