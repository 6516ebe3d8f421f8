#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/edits.h"
#include "app/page_documents.h"
#include "app/runs.h"

namespace gradmesh {

/// Returns what is told of a mesh but for its elements: {"id", "role": "fill", "stroke" or null,
/// "simplified", "remembers", "color_model", "smooth", "handles", "patches", "objects", "points",
/// "t_junctions"}, with counts from "handles", as of count_handles, on. Only the first three if the
/// mesh cannot be read.
nlohmann::ordered_json mesh_json(const Document& document, const MeshEntry& entry);

/// Returns what is told of a run on one mesh of a document: {"id", "method", "color_model",
/// "metric", "epsilon", "max_local_error" or null, "original" or null, "resolution", "seed",
/// "omega", "kappa", "handles_before", "handles_after", "patches_before", "patches_after",
/// "objects", "error", "local_error", "evaluations", "renderer", "seconds": {"total", "rasterize",
/// "select"}, "stopped"}, and "weights": [{"id", "factor"}] if there are any. `original` names the
/// document that was measured against; empty if none was named.
nlohmann::ordered_json result_json(const Document& document, const MeshReport& report,
                                   const RunOptions& options, const std::string& original);

/// Returns what is told of an edit: {"id", "handles_before", "handles_after", "patches_before",
/// "patches_after", "objects", "error"}.
nlohmann::ordered_json edit_json(const EditReport& report);

/// Returns what is told of a mesh of a page: "found" of info_json() below.
nlohmann::ordered_json found_json(const FoundMesh& found);

/// Returns the contents of a document:
///   {"file", "kind": "svg" or another format's name,
///    "meshes": [those of mesh_json, with "elements" as of elements_json
///               (formats/json/elements.h) or, if the mesh cannot be read, "refused", the reason],
///    "unused": [{"id", "patches"}]}
/// where "unused" are mesh gradients that paint nothing. Of a document of pages, "kind" is "pdf" or
/// "postscript", there is "left_out": [sentences], and each mesh has "found": {"page", "number",
/// "type", "shadings", "patches", "handles", "rows", "columns", "joined", "record", "smooth",
/// "difference"}, as of FoundMesh.
nlohmann::ordered_json info_json(const Document& document);

/// Returns what info_json() returns as text, with one element on each line.
std::string info_text(const Document& document);

}  // namespace gradmesh
