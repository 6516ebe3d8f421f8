#pragma once

#include <string>
#include <vector>

#include "draw/drawing.h"
#include "draw/subject.h"
#include "methods/edges.h"
#include "methods/motorcycle.h"
#include "methods/regions.h"

namespace gradmesh {

/// What a mesh is made of (B.1): curves, control points, T-junctions and handles.
Drawing draw_edges(const Subject& subject);

/// The patches in the means of their corners' colours, with their numbers.
Drawing draw_faces(const Subject& subject);

/// What merging single edges costs (B.3), as colours; `measure` says by what, for the legend.
Drawing draw_errors(const Subject& subject, const std::vector<EdgePrice>& prices,
                    const std::string& measure);

/// The motorcycle graph and its parts (Fig. 8); `limit` is what costly edges exceed.
Drawing draw_motorcycle(const Subject& subject, const MotorcycleGraph& graph, double limit);

/// One patch and, of the regions that hold it, the one at place `shown` (all where that is not
/// among them), with a list of all.
Drawing draw_regions(const Subject& subject, Face patch, const std::vector<RegionPrice>& regions,
                     int shown);

}  // namespace gradmesh
