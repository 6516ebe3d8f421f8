#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/document/found_pages.h"
#include "app/editing/edits.h"
#include "app/pictures/trace.h"
#include "app/runs/curves.h"
#include "app/runs/runs.h"

namespace gradmesh {

/// Results as `--report`, `--json` and the Python package have them.

/// Returns what is told of a mesh but for its elements: {"id", "role": "fill", "stroke" or null,
/// "simplified", "remembers", "color_model", "smooth", "handles", "patches", "objects", "points",
/// "t_junctions"}, with counts from "handles", as of count_handles, on. Only the first three if the
/// mesh cannot be read.
nlohmann::ordered_json mesh_json(const MeshSource& document, const MeshEntry& entry);

/// Returns what is told of a run on one mesh of a document: {"id", "method", "color_model",
/// "metric", "epsilon", "max_local_error" or null, "original" or null, "resolution", "seed",
/// "omega", "kappa", "handles_before", "handles_after", "patches_before", "patches_after",
/// "objects", "error", "local_error", "evaluations", "renderer", "seconds": {"total", "rasterize",
/// "select"}, "stopped"}, and "weights": [{"id", "factor"}] if there are any. `original` names the
/// document that was measured against; empty if none was named.
nlohmann::ordered_json result_json(const MeshSource& document, const MeshReport& report,
                                   const RunOptions& options, const std::string& original);

/// Returns what is told of an edit: {"id", "handles_before", "handles_after", "patches_before",
/// "patches_after", "objects", "error"}.
nlohmann::ordered_json edit_json(const EditReport& report);

/// Returns what is told of a mesh of a page: "found" of info_json() below.
nlohmann::ordered_json found_json(const FoundMesh& found);

/// Returns what is told of a trace, all of Tracing but the ids.
nlohmann::ordered_json tracing_json(const Tracing& tracing);

/// Returns {"meshes": [{"id", "kind", "states": [{"handles", "patches", "objects", "error",
/// "local_error"}], "marks": {"gentle": 3}}]}.
nlohmann::ordered_json curves_json(const std::vector<MeshCurve>& curves);
/// Returns the member of a curve there, without "id".
nlohmann::ordered_json curve_json(MeshKind kind, const StateCurve& curve);
/// Returns what curves_json does, of the one mesh of an object with this id.
nlohmann::ordered_json traced_curve_json(const std::string& id, const StateCurve& curve);

}  // namespace gradmesh
