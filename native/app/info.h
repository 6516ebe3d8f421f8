#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/document.h"

namespace gradmesh {

/// Returns the contents of a document:
///   {"file", "kind": "svg" or another format's name,
///    "meshes": [{"id", "role": "fill", "stroke" or null, "simplified", "color_model",
///                "handles", "patches", "objects", "points", "t_junctions", "elements"}],
///    "unused": [{"id", "patches"}]}
/// where a mesh that cannot be read has "refused", the reason, in the place of all from
/// "color_model" on, and "unused" are mesh gradients that paint nothing; with counts in "handles",
/// as of count_handles, to "t_junctions", and "elements" as of elements_json
/// (formats/json/elements.h).
nlohmann::ordered_json info_json(const Document& document);

/// Returns the same as text, with one element on each line.
std::string info_text(const Document& document);

}  // namespace gradmesh
