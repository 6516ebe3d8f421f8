#pragma once

#include <vector>

#include "base/progress.h"
#include "methods/merging/regions.h"
#include "problem/problem.h"

namespace gradmesh {

/// Merges as gqe does, and fits. Fitting a merged mesh to the picture lowers its error, often to
/// less than half: so sets of regions that together cost more than epsilon are merged as well, if
/// they keep to epsilon once fitted. From the best of these sets, or from the mesh that gqe merged,
/// merging goes on in rounds, each priced, merged and fitted on the mesh as it then is, until
/// nothing more keeps to epsilon.
///
/// Returns the mesh with the fewest patches, which never has more than that of gqe. Where handles
/// are made few of a mesh of the model `bilinear`, what is plain stays so while regions are merged
/// (Plainness), and handles are dropped with what is left of epsilon: returns the mesh that
/// leaves least to handle.
Candidate merge_and_fit(const Problem& problem, StopWatch& watch);

/// Returns for each of the regions, in their order, by how much the error rises if it alone is
/// merged and its patch fitted: at most its price, which must be at most `limit`. For regions that
/// `watch` leaves no time for it is the price itself.
std::vector<double> fitted_prices(FitTrial& trial, const std::vector<RegionPrice>& regions,
                                  double limit, StopWatch& watch);

}  // namespace gradmesh
