#pragma once

#include <string>
#include <vector>

#include "draw/drawing.h"
#include "draw/subject.h"
#include "methods/merging/edges.h"
#include "methods/merging/motorcycle.h"
#include "methods/merging/regions.h"

namespace gradmesh {

/// Draws the elements of a mesh (B.1): curves, control points, T-junctions and handles.
Drawing draw_edges(const Subject& subject);

/// Draws the patches in the means of their corners' colours, with their numbers.
Drawing draw_faces(const Subject& subject);

/// Draws the prices of single edges (B.3) as colours. `measure` names the error for the legend.
Drawing draw_errors(const Subject& subject, const std::vector<EdgePrice>& prices,
                    const std::string& measure);

/// Draws the motorcycle graph and its parts (Fig. 8). `limit` is the price that costly edges
/// exceed.
Drawing draw_motorcycle(const Subject& subject, const MotorcycleGraph& graph, double limit);

/// Draws one patch and, of the regions that hold it, the one with index `shown`, or all if there is
/// none, with a list of all.
Drawing draw_regions(const Subject& subject, Face patch, const std::vector<RegionPrice>& regions,
                     int shown);

}  // namespace gradmesh
