#pragma once

#include <optional>
#include <string>

#include "app/runs.h"
#include "report/report.h"

namespace gradmesh {

/// How a report on a mesh is made.
struct ReportOptions {
  /// What `simplify --report` has written of the run; empty if there is nothing. Its metric,
  /// epsilon, resolution and colour model count where none are given here.
  std::string run;
  /// What sentences call it.
  std::string run_name = "run";
  std::optional<MetricKind> metric;
  std::optional<double> epsilon;
  std::optional<int> resolution;
  /// How the mesh before is priced, and in which colour model; the three options above are set in
  /// it.
  RunOptions pricing;
  /// Where known prices are read from, and those that were found are written to.
  AnalysisPaths analyses;
};

/// Returns what a report says of a mesh before and after its simplification. The mesh before is
/// priced, unless it is smooth, with the fits of its regions if the run's method fits what it
/// merges; with fewer prices if the caller cancels. Throws InputError with `run_name` if the
/// text of the run is no such report, or says nothing of the mesh.
Report report_on_mesh(const Document& before, const MeshEntry& entry, const Document& after,
                      const MeshEntry& entry_after, const ReportOptions& options);

}  // namespace gradmesh
