#include "app/editing/to_one_mesh.h"

#include <utility>

#include "app/document/document.h"
#include "app/document/frames.h"
#include "mesh/build.h"
#include "mesh/subdivide.h"
#include "ops/split/split_line.h"
#include "problem/problem.h"

namespace gradmesh {
namespace {

constexpr int most_patches = 100000;

/// Returns the surface of a mesh without T-junctions.
Mesh without_junctions(Mesh mesh) {
  Journal journal(mesh);
  extend_stems(journal, most_patches);
  return build_mesh(subdivided(mesh, 1));
}

}  // namespace

std::vector<EditReport> to_one_mesh(Document& document, const std::vector<std::string>& ids,
                                    const MeasureOptions& measure) {
  std::vector<std::pair<MeshEntry, Mesh>> ordinary;
  std::vector<EditReport> reports;
  for (const MeshEntry& entry : document.selected(ids)) {
    if (!document.can_be_one(entry)) continue;
    const Mesh before = document.mesh(entry);
    document.naming(entry, [&] {
      const Mesh& one = ordinary.emplace_back(entry, without_junctions(before)).second;
      document.check_one(one);
      Problem problem(std::make_shared<const Mesh>(before), nullptr,
                      layout_of(document, entry, false), measure.resolution, measure.metric);
      problem.rules = document.rules_of_one(entry);
      const Candidate written = problem.measure(one);
      reports.push_back({entry.id, counts_of(before), written.counts(), 1, written.error});
    });
  }
  if (ordinary.empty())
    throw InputError(
        "{0}: only simplified meshes, of blocks or with T-junctions, can be made one ordinary "
        "mesh.",
        document.name());
  document.write_as_one(ordinary, measure.resolution);
  return reports;
}

}  // namespace gradmesh
