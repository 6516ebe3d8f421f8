#pragma once

#include "app/document/mesh_source.h"
#include "app/editing/edits.h"
#include "app/runs/runs.h"
#include "service/call.h"

namespace gradmesh {

/// The options that several functions share, from the arguments of a call; those that are null have
/// their defaults. All throw WrongType, and std::invalid_argument where there is nothing of a name
/// that is given, or where options contradict each other.

/// Returns the options of a run that the arguments name (simplify/options.h), with the
/// questions about progress.
RunOptions run_options(const Call& call);
/// Sets where errors are found, as the arguments say.
void take_renderer(RunOptions& options, const Call& call);
PricePaths analysis_paths(const Call& call);
MeasureOptions measure_options(const Call& call);

/// Lets a document be measured against another one while it lives.
class MeasuredAgainst {
 public:
  /// The other one is the argument `original`; none if that is null.
  MeasuredAgainst(Document& document, const Call& call) : document_(document) {
    document_.measure_against(call.optional_document("original"));
  }
  MeasuredAgainst(const MeasuredAgainst&) = delete;
  MeasuredAgainst& operator=(const MeasuredAgainst&) = delete;
  ~MeasuredAgainst() { document_.measure_against(nullptr); }

 private:
  Document& document_;
};

/// Returns the path that an argument holds; empty if it is null.
std::filesystem::path path_argument(const Call& call, const std::string& name);

/// Returns the mesh of the object that the argument `id` names, its fill if fill and stroke are
/// meshes. If it is null, or if it is that of an element around meshes, returns the only one there.
/// Throws InputError if there are several.
inline MeshEntry one_mesh(const Document& document, const Call& call) {
  const auto id = call.get<std::optional<std::string>>("id");
  const std::vector<std::string> ids = id ? std::vector{*id} : std::vector<std::string>{};
  for (const MeshEntry& entry : document.selected(ids))
    if (entry.id == id) return entry;
  return one_mesh(document, ids, "its id");
}

}  // namespace gradmesh
