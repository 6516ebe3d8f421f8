#pragma once

#include <vector>

#include "mesh/region.h"
#include "ops/journal.h"

namespace gradmesh {

/// Merges a region into one patch, as one operation of the journal for each merge: first along
/// its longer direction, which has turned out to change the mesh less, then the long patches with
/// each other. `tops` as of region_tops. False where one of the merges cannot be made
/// (can_merge): then nothing is changed.
bool merge_region(Journal& journal, const Region& region, const std::vector<Halfedge>& tops);

}  // namespace gradmesh
