#pragma once

#include <nlohmann/json.hpp>

#include "report/report.h"

namespace gradmesh {

/// Returns the data of the page's scripts:
///   {"id", "width", "height",                    pixels of the pictures
///    "heeded_by": {option: [methods]},           of options that only some methods heed
///    "metric": "FLIP", "error", "local_error", "epsilon",
///    "errors": {"picture", "largest", "scale": ["#rrggbb", ...]}, scale from 0 to largest
///    "worst": [{"x", "y", "error"}, ...],        metric/worst_places.h, in pixels
///    "run": {...} or null,
///    "before": mesh, "after": mesh}
/// with pictures as `data:` addresses, and a mesh as
///   {"file", "picture", "color_model", "handles", "patches", "objects", "points", "t_junctions",
///    "elements": {...},                          formats/json/elements.h
///    "curves": [[x0, y0, ..., x3, y3], ...],     Bezier points in pixels, one for each half-edge
///    "hermite": [[[x, y, r, g, b, a], x 16], ...],  row by row (Eq. 3), one for each face
///    "merging": [...],   for each half-edge the price of merging it, why it cannot be, or null
///    "regions": [{"rows", "columns", "error", "fitted", "faces": [...]}, ...]}  by rising size
/// In "after" the last two are empty; "fitted" is null if it was not worked out.
nlohmann::ordered_json page_data(const Page& page);

}  // namespace gradmesh
