#pragma once

#include <vector>

#include "app/document/svg_document.h"
#include "app/export/info.h"
#include "app/export/publish.h"
#include "app/export/publish_code.h"
#include "app/runs/runs.h"
#include "service/arguments.h"

namespace gradmesh {

/// What functions return of the core's own records, as objects whose members are named as in
/// docs/reference/helper.md.

/// Returns [template, [arguments]], where arguments are texts or such pairs.
Json message_json(const Message& message);

/// Returns all meshes that are not hidden originals. Throws InputError if there is none.
Json meshes_json(const Document& document);

/// Returns what became of each mesh in a run; `original` as of result_json.
Json results_json(const Document& document, const std::vector<MeshReport>& reports,
                  const RunOptions& options, const std::string& original);
Json update_json(const UpdateReport& report);
Json published_json(const PublishedMesh& mesh);
Json published_code_json(const PublishedCode& mesh);

}  // namespace gradmesh
