#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/runs/runs.h"
#include "report/report.h"

namespace gradmesh {

/// How a page on a mesh is made.
struct ReportPageOptions {
  /// The results of the run, as `simplify --report` writes them; nothing if they are not known.
  std::optional<std::string> run;
  /// What sentences call the results.
  std::string run_name = "run";
  /// How the mesh before is priced, and in which colour model.
  RunOptions pricing;
  /// The names of those options of `pricing` that count whatever the results of the run say of
  /// metric, epsilon, resolution and colour model.
  std::vector<std::string> given;
  /// Where known prices are read from, and those that were found are written to.
  PricePaths analyses;
};

/// Returns what a page says of a mesh before and after its simplification. The mesh before is
/// priced, unless it is smooth, with the fits of its regions if the run's method fits what it
/// merges; with fewer prices if the caller cancels. Throws InputError with `run_name` if the
/// results of the run are none, or say nothing of the mesh.
Page page_on_mesh(const Document& before, const MeshEntry& entry, const Document& after,
                  const MeshEntry& entry_after, const ReportPageOptions& options);

}  // namespace gradmesh
