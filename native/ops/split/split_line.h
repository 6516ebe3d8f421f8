#pragma once

#include "ops/journal.h"

namespace gradmesh {

/// Splits the patch of the leaf `side` from its point t, as split() does, then the patch beyond the
/// side opposite, and so on, up to the boundary, or to a T-junction that is there already, whose
/// stem continues the line. Each patch is one operation of the journal. Where the line meets
/// itself, round a ring, it ends.
void split_line(Journal& journal, Halfedge side, double t);

/// Splits a line of patches as split_line() does, in both directions: also through the patches
/// across `side`.
void split_line_across(Journal& journal, Halfedge side, double t);

/// Continues the stem of every T-junction across the mesh, so that no patch has a T-junction on its
/// sides: where two lines meet, both sides of a curve are divided in the same place, and
/// subdivided(mesh, 1) makes an ordinary point of it. Throws InputError where that would take more
/// than `most_patches`.
void extend_stems(Journal& journal, int most_patches);

}  // namespace gradmesh
