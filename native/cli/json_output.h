#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "app/runs.h"

namespace gradmesh {

/// {"meshes": [{"id", "method", "color_model", "metric", "epsilon", "max_local_error" or null,
///  "original" or null, "resolution", "seed", "omega", "kappa", "handles_before", "handles_after",
///  "patches_before", "patches_after", "objects", "error", "local_error", "evaluations", "seconds":
///  {"total", ...}, "stopped"}]}
/// and {"id", "refused"} with the reason for those that cannot be read.
/// The options name the colour model; `original` is the file measured against, if one was given.
nlohmann::ordered_json report_json(const std::vector<MeshReport>& reports,
                                   const SimplifyOptions& options, const std::string& original);

}  // namespace gradmesh
