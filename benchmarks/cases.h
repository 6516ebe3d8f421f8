#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <string>

#include "base/parallel.h"
#include "inputs.h"

namespace gradmesh::bench {

/// Each registers the benchmarks of one kind, under names that scripts/bench knows.
void register_painting();
void register_cairo();  ///< Defined only where cairo was found.
void register_metrics();
void register_merges();
void register_assembly();
void register_methods();
void register_growth();
void register_pricing();
void register_traces();
#ifdef GRADMESH_WINDOW
void register_window();
#endif

using Run = std::function<void(benchmark::State&)>;
using RunOnMesh = std::function<void(benchmark::State&, const MeshFile&)>;

/// Registers a benchmark of one thread, timed by what the processor spends on it.
inline void add(const std::string& name, const Run& run) {
  const auto on_one_thread = [run](benchmark::State& state) {
    const ThreadLimit one(1);
    run(state);
  };
  benchmark::RegisterBenchmark(name.c_str(), on_one_thread)->Unit(benchmark::kMillisecond);
}

/// The same on as many threads as `run` takes, timed by the clock on the wall, with the time of the
/// processor in all threads beside it. Google Benchmark adds "/process_time/real_time" to the name.
inline void add_parallel(const std::string& name, const Run& run) {
  benchmark::RegisterBenchmark(name.c_str(), run)
      ->MeasureProcessCPUTime()
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

/// Adds what became of a mesh to a line of results.
inline void count(benchmark::State& state, const SimplifyResult& result) {
  state.counters["patches"] = result.patches_before;
  state.counters["left"] = result.patches_after;
  state.counters["evaluations"] = result.evaluations;
}

/// A run on a mesh; where the file is absent the result says so.
inline Run on(const MeshFile& file, const RunOnMesh& run) {
  return [=](benchmark::State& state) {
    if (file.exists()) return run(state, file);
    state.SkipWithError((file.path.filename().string() + " is absent").c_str());
  };
}

}  // namespace gradmesh::bench
