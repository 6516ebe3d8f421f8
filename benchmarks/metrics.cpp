#include "base/parallel.h"
#include "cases.h"
#include "metric/metric.h"

namespace gradmesh::bench {
namespace {

void score(benchmark::State& state, MetricKind kind) {
  const auto [reference, test] = image_pair(700, 700);
  const auto metric = make_metric(kind, reference);
  double error = 0;
  for (auto _ : state) error = mean(metric->map(test));
  state.counters["error"] = error;
}

/// All that depends on the reference alone.
void prepare(benchmark::State& state, MetricKind kind) {
  const Image reference = image_pair(700, 700).first;
  for (auto _ : state) benchmark::DoNotOptimize(make_metric(kind, reference));
}

}  // namespace

void register_metrics() {
  for (const MetricKind kind : {MetricKind::ssim, MetricKind::flip}) {
    const std::string line = name(kind);
    add(line + "/1-thread", [=](auto& state) { score(state, kind); });
    add_parallel(line + "/2-threads", [=](auto& state) {
      const ThreadLimit two(2);
      score(state, kind);
    });
    add(line + "/reference", [=](auto& state) { prepare(state, kind); });
  }
}

}  // namespace gradmesh::bench
