#include "base/parallel.h"
#include "cases.h"
#include "metric/metric.h"

namespace gradmesh::bench {
namespace {

/// As every edit is measured: what depends on the reference alone is known.
void score(benchmark::State& state, MetricKind kind) {
  const auto [reference, test] = image_pair(700, 700);
  const auto metric = make_metric(kind, reference);
  double error = 0;
  for (auto _ : state) error = mean(metric->map(test));
  state.counters["error"] = error;
}

/// As scikit-image and the FLIP reference do it, who prepare both images every time.
void score_from_scratch(benchmark::State& state, MetricKind kind) {
  const auto [reference, test] = image_pair(700, 700);
  for (auto _ : state) benchmark::DoNotOptimize(mean(make_metric(kind, reference)->map(test)));
}

void on_two_threads(const std::string& name, const Run& run) {
  add_parallel(name, [run](benchmark::State& state) {
    const ThreadLimit two(2);
    run(state);
  });
}

}  // namespace

void register_metrics() {
  for (const MetricKind kind : {MetricKind::ssim, MetricKind::flip}) {
    const std::string line = name(kind);
    const Run known = [=](auto& state) { score(state, kind); };
    const Run from_scratch = [=](auto& state) { score_from_scratch(state, kind); };
    add(line + "/1-thread", known);
    add(line + "/1-thread/from-scratch", from_scratch);
    on_two_threads(line + "/2-threads", known);
    on_two_threads(line + "/2-threads/from-scratch", from_scratch);
  }
}

}  // namespace gradmesh::bench
