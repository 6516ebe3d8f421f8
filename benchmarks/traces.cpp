#include "app/pictures/trace.h"
#include "cases.h"

namespace gradmesh::bench {
namespace {

/// A trace of one of the sample photographs: of what its outline surrounds, or as a whole.
struct TraceCase {
  std::string name, sample, id;
  int handles;
};

void run(benchmark::State& state, const TraceCase& c) {
  const std::filesystem::path file =
      std::filesystem::path(GRADMESH_SOURCE_DIR) / "samples" / "photographs" / (c.sample + ".svg");
  TraceOptions options;
  options.handles = c.handles;
  options.epsilon = 0;
  options.threads = 1;
  Tracing tracing;
  for (auto _ : state) tracing = trace_file_in_shape({}, 700, file, c.id, options).tracing;
  state.counters["patches"] = tracing.counts.patches;
  state.counters["error"] = tracing.errors.flip;
}

}  // namespace

/// With the reading and the painting of the picture, as a person waits for all of it.
void register_traces() {
  for (const TraceCase& c : {TraceCase{"outline/150", "apple", "apple", 150},
                             TraceCase{"whole/289", "cat", "photograph", 289},
                             TraceCase{"whole/625", "cat", "photograph", 625}})
    add("trace/" + c.name, [c](benchmark::State& state) { run(state, c); });
}

}  // namespace gradmesh::bench
