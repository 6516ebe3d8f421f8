#include "base/parallel.h"
#include "cases.h"
#include "metric/metric.h"

namespace gradmesh::bench {
namespace {

void score(benchmark::State& state, MetricKind kind, int threads) {
  const ThreadLimit limit(threads);
  const auto [reference, test] = image_pair(700, 700);
  const auto metric = make_metric(kind, reference);
  double error = 0;
  for (auto _ : state) error = mean(metric->map(test));
  state.counters["error"] = error;
}

}  // namespace

void register_metrics() {
  for (const MetricKind kind : {MetricKind::ssim, MetricKind::flip}) {
    add(std::string(name(kind)) + "/1-thread", [=](auto& state) { score(state, kind, 1); });
    add(std::string(name(kind)) + "/2-threads", [=](auto& state) { score(state, kind, 2); });
    // All that depends on the reference alone.
    add(std::string(name(kind)) + "/reference", [=](auto& state) {
      const ThreadLimit one(1);
      const Image reference = image_pair(700, 700).first;
      for (auto _ : state) benchmark::DoNotOptimize(make_metric(kind, reference));
    });
  }
}

}  // namespace gradmesh::bench
