#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/document/mesh_source.h"

namespace gradmesh {

/// Returns the contents of a document:
///   {"file", "kind": "svg" or another format's name,
///    "meshes": [those of mesh_json, with "elements" as of elements_json
///               (formats/json/elements.h) or, if the mesh cannot be read, "refused", the reason],
///    "unused": [{"id", "patches"}]}
/// where "unused" are mesh gradients that paint nothing. Of a document of pages, "kind" is "pdf" or
/// "postscript", there is "left_out": [sentences], and each mesh has "found": {"page", "number",
/// "type", "shadings", "patches", "handles", "rows", "columns", "joined", "record", "smooth",
/// "difference"}, as of FoundMesh.
nlohmann::ordered_json info_json(const MeshSource& document);

/// Returns what info_json() returns as text, with one element on each line.
std::string info_text(const MeshSource& document);

}  // namespace gradmesh
