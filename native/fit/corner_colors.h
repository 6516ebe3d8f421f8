#pragma once

#include <vector>

#include "ops/journal.h"

namespace gradmesh {

/// Returns how much a difference of colour, in levels of 8 bits, counts: pixels are rounded, so
/// that even a small difference changes the level of some, and FLIP charges one level nearly as
/// much as a few.
double visible_difference(double levels);

/// Returns the corners whose colour is free to change, each as the leaves that start at one point
/// in that colour: all but those at T-junctions that follow their parent's curve.
std::vector<std::vector<Halfedge>> free_corners(const Mesh& mesh);

/// Changes a channel of the colour of a corner by `by` levels of 8 bits, as a part of the journal's
/// operation. The colours of T-junctions that depend on the corner follow. Returns false if there
/// is no such level.
bool change_corner(Journal& journal, const std::vector<Halfedge>& corner, int channel, int by);

/// Chooses the colours of the corners of a mesh of the model `bilinear`, each in 8 bits, so that
/// its patches come close to `wanted`, patches with the same geometry, by the slots of the faces.
/// Corners that meet in one colour keep one, and those at T-junctions that follow their parent's
/// curve follow it. Opacities stay.
void fit_corner_colors(Mesh& mesh, const std::vector<Patch>& wanted);

}  // namespace gradmesh
