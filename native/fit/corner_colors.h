#pragma once

#include <vector>

#include "ops/journal.h"

namespace gradmesh {

/// How much a difference of colour, in levels of 8 bits, counts: pixels are rounded, so that even a
/// small one changes the level of some, and FLIP charges single levels nearly as much as a few.
double visible_difference(double levels);

/// The leaves that start in one colour which is free to be another, those of one point together:
/// all but those at T-junctions that follow their parent's curve.
std::vector<std::vector<Halfedge>> free_corners(const Mesh& mesh);

/// Changes a channel of such a colour by so many levels of 8 bits, as a part of the journal's
/// operation; what hangs on it follows. Returns false where there is no such level.
bool change_corner(Journal& journal, const std::vector<Halfedge>& corner, int channel, int by);

/// Chooses the colours of the corners of a mesh of the model `bilinear`, each in 8 bits, so that
/// its patches come close to others with the same geometry: `wanted`, by the slots of the faces.
/// Corners that meet in one colour keep one, and those at T-junctions that follow their parent's
/// curve follow it. Opacities stay.
void fit_corner_colors(Mesh& mesh, const std::vector<Patch>& wanted);

}  // namespace gradmesh
