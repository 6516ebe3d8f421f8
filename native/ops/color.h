#pragma once

#include <vector>

#include "ops/journal.h"

namespace gradmesh {

/// The colours at a point: one for all patches around it, or several, between which the colour
/// changes sharply, as in meshes that the paper takes (4.1). A corner is named by the leaf that
/// starts there.

/// Returns the corners of patches at a point, in the order of their indices. At a T-junction there
/// are two.
std::vector<Halfedge> corners_at(const Mesh& mesh, Point point);

/// Returns true if the colour of a corner may change: no patch would change with it that must stay
/// as it is.
bool can_recolor(const Mesh& mesh, Halfedge corner);

/// Sets the colour of one corner, as one operation of the journal. Where the other corners at its
/// point have another colour, the colours are sharp there. T-junctions on the sides of the corner
/// follow, unless they have colours of their own.
void recolor(Journal& journal, Halfedge corner, const glm::dvec4& color);

/// Gives all corners at a point one colour again, as one operation of the journal: the mean of
/// theirs, or at a T-junction the colour of the curve on which it lies. All of them can_recolor().
void join_colors(Journal& journal, Point point);

}  // namespace gradmesh
