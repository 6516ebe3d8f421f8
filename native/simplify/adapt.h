#pragma once

#include "problem/problem.h"

namespace gradmesh {

/// Returns the mesh of the problem in the colour model `bilinear`, with patches split until the
/// error is at most epsilon. New patches end in T-junctions. The 8-bit colours of the corners are
/// chosen to come close to the original (fit/corner_colors.h). If the error is still too large,
/// twists and tangents are fitted to the picture (trial/fit_trial.h). Returns the mesh with the
/// least error that was found if no number of patches up to the limit (base/limits.h) keeps to
/// epsilon.
Candidate adapted(const Problem& problem);

}  // namespace gradmesh
