#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <string>

#include "inputs.h"

namespace gradmesh::bench {

/// Each registers the benchmarks of one kind, under names that scripts/bench knows.
void register_painting();
void register_cairo();  ///< Defined only where cairo was found.
void register_metrics();
void register_merges();
void register_methods();
void register_growth();

/// Registers a benchmark that is timed by the wall's clock.
inline void add(const std::string& name, std::function<void(benchmark::State&)> run) {
  benchmark::RegisterBenchmark(name.c_str(), std::move(run))
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

/// The same for a benchmark of a mesh; where its file is absent the result says so.
inline void add(const std::string& name, const MeshFile& file,
                std::function<void(benchmark::State&, const MeshFile&)> run) {
  add(name, [=](benchmark::State& state) {
    if (file.exists()) return run(state, file);
    state.SkipWithError((file.path.filename().string() + " is absent").c_str());
  });
}

}  // namespace gradmesh::bench
