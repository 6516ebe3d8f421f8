#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/pictures/part_tracer.h"
#include "simplify/curve.h"

namespace gradmesh {

/// Returns the curve of meshes of one gradient, each with fewer handles than the one before. Errors
/// are those against the picture without what is smaller than the detail, as of
/// TraceOptions::epsilon. An amount's mark is at the last state that is within its
/// Amount::traced_epsilon; none where no state is.
Curve traced_curve(std::vector<Mesh> meshes, const PartTracer& tracer);

}  // namespace gradmesh
