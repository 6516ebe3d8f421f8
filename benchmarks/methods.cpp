#include "app/pages/read_document.h"
#include "app/runs/runs.h"
#include "cases.h"
#include "mesh/rectangle.h"

namespace gradmesh::bench {
namespace {

void run(benchmark::State& state, const MeshFile& file, const RunOptions& options) {
  const auto document = read_document(file.path);
  SimplifyResult result;
  for (auto _ : state) result = preview(*document, {file.id}, options).front().result;
  state.SetLabel(result.renderer);
  count(state, result);
  state.counters["error"] = result.error;
}

bool suits(const std::string& method, const MeshFile& file) {
  return !std::filesystem::exists(file.path) || suits(method_named(method), Input(file).mesh);
}

void add_methods(const MeshFile& file, MetricKind metric, double epsilon) {
  for (const std::string& method : method_names()) {
    if (method == "manual" || !suits(method, file)) continue;
    RunOptions options;
    options.method = method;
    options.metric = metric;
    options.epsilon = epsilon;
    add_parallel(std::string("method/") + method + "/" + file.name + "/" + name(metric),
                 on(file, [=](auto& state, auto& f) { run(state, f, options); }));
  }
}

}  // namespace

/// On all cores, at the thresholds that the paper compares methods at.
void register_methods() {
  for (const MeshFile& file : paper_meshes()) {
    add_methods(file, MetricKind::ssim, 0.005);
    add_methods(file, MetricKind::flip, 0.02);
  }
  for (const MeshFile& file : sample_meshes()) add_methods(file, MetricKind::flip, 0.01);
}

}  // namespace gradmesh::bench
