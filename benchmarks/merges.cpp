#include <set>

#include "cases.h"
#include "mesh/region.h"
#include "ops/merge/merge_region.h"
#include "raster/rasterizer.h"
#include "trial/merge_trial.h"

namespace gradmesh::bench {
namespace {

/// All regions of that many patches that can be merged, each once.
std::vector<Region> candidates(Mesh& mesh, int rows, int columns) {
  std::set<Region> names;
  for (const Face face : mesh.faces())
    for (int top = 0; top < 4; ++top) {
      const Region region{face, top, rows, columns};
      const auto tops = region_tops(mesh, region);
      if (!tops.empty()) names.insert(region_name(mesh, region, tops));
    }
  Journal journal(mesh);
  std::vector<Region> result;
  for (const Region& region : names) {
    if (merge_region(journal, region).valid()) result.push_back(region);
    journal.undo_to(0);
  }
  return result;
}

/// Each iteration goes once over all regions of that size; the rate of items is that of regions.
void merge_and_undo(benchmark::State& state, const MeshFile& file, int rows, int columns) {
  Input input(file);
  const auto regions = candidates(input.mesh, rows, columns);
  Journal journal(input.mesh);
  for (auto _ : state)
    for (const Region& region : regions) {
      merge_region(journal, region);
      journal.undo_to(0);
    }
  state.SetItemsProcessed(state.iterations() * int(regions.size()));
}

/// Merge, paint, measure and undo, of all regions of 2 x 2 patches in turn; none shares merges with
/// the one before.
void price(benchmark::State& state, const MeshFile& file, MetricKind metric) {
  Input input(file);
  const auto regions = candidates(input.mesh, 2, 2);
  const Mesh start = input.mesh;
  MergeTrial trial(
      input.mesh,
      EditError(std::make_shared<const Reference>(start, input.frame(700), metric), start), 1);
  for (auto _ : state)
    for (const Region& region : regions)
      benchmark::DoNotOptimize(RegionTrial(trial, start).price(region));
  state.SetItemsProcessed(state.iterations() * int(regions.size()));
}

/// What a candidate costs without windows: the whole frame is painted, and every pixel scored,
/// for which all of them differ.
void whole_frame(benchmark::State& state, const MeshFile& file, MetricKind kind) {
  const Input input(file);
  const Frame frame = input.frame(700);
  const auto rasterizer = make_software_rasterizer();
  const Image reference = rasterizer->paint(input.mesh, frame);
  const auto metric = make_metric(kind, reference);
  Image test = reference;
  for (auto& sample : test.samples) sample ^= 1;
  for (auto _ : state) {
    benchmark::DoNotOptimize(rasterizer->paint(input.mesh, frame));
    benchmark::DoNotOptimize(mean(metric->map(test)));
  }
}

}  // namespace

void register_merges() {
  const MeshFile duck = mesh_file("duck");
  const auto add_merges = [&](const char* name, int rows, int columns) {
    add(name, on(duck, [=](auto& state, auto& f) { merge_and_undo(state, f, rows, columns); }));
  };
  add_merges("merge-undo/pair", 1, 2);
  add_merges("merge-undo/2x2", 2, 2);
  for (const MetricKind metric : {MetricKind::ssim, MetricKind::flip}) {
    const auto add_duck = [&](const std::string& work, auto run) {
      add(work + "/" + name(metric),
          on(duck, [=](auto& state, auto& f) { run(state, f, metric); }));
    };
    add_duck("candidate", price);
    add_duck("whole-frame", whole_frame);
  }
}

}  // namespace gradmesh::bench
