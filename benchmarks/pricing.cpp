/// What the renderers differ in: pricing, of a mesh of 1,600 patches at 1000 pixels.
#include "block_mesh.h"
#include "cases.h"
#include "mesh/region.h"
#include "pricing/batch_prices.h"

namespace gradmesh::bench {
namespace {

constexpr int blocks = 8, resolution = 1000;

using Price = std::function<void(const Problem&, StopWatch&)>;

void price(benchmark::State& state, const Price& price, std::shared_ptr<Device> device) {
  const Mesh mesh = block_mesh(blocks);
  RunOptions options;
  options.resolution = resolution;
  options.device = std::move(device);
  std::string fault;
  options.device_lost = [&](const DeviceError& error) { fault = error.what(); };
  // Shaders are built once in a run of the program.
  const auto run = [&](const Mesh& priced, const Price& work) {
    StopWatch watch = watch_of(options);
    work(problem_of(std::make_shared<const Mesh>(priced), options), watch);
  };
  if (options.device) run(block_mesh(1), analyze_edges);
  for (auto _ : state) run(mesh, price);
  state.counters["patches"] = mesh.face_count();
  state.SetLabel(options.device ? options.device->info().name : "software");
  if (!fault.empty()) state.SkipWithError(fault.c_str());
}

void price_on_device(benchmark::State& state, const Price& work) {
  if (const auto device = Device::open(false)) return price(state, work, device);
  state.SkipWithError("EGL offers no device");
}

/// What of that a device leaves to the cores: all inner edges are merged, and it is said what each
/// would paint.
void describe(benchmark::State& state) {
  Mesh mesh = block_mesh(blocks);
  const Mesh start = mesh;
  RunOptions options;
  const Frame frame = fit_frame(mesh, options.view, resolution, options.padding);
  MergeTrial trial(
      mesh, EditError(std::make_shared<const Reference>(start, frame, options.metric), start),
      options.epsilon);
  ParallelTrials trials(trial);
  std::vector<Region> regions;
  for (const Halfedge edge : inner_edges(start))
    if (can_merge(start, edge) == MergeObstacle::none)
      regions.push_back(region_of_edge(start, edge));
  for (auto _ : state)
    trials.for_each(
        regions.size(), [](std::size_t) { return false; },
        [&](MergeTrial& own, std::size_t i) {
          EditTile tile;
          benchmark::DoNotOptimize(RegionTrial(own, start).describe(regions[i], tile));
        });
  state.counters["patches"] = start.face_count();
}

}  // namespace

void register_pricing() {
  const auto add_both = [](const std::string& work, const Price& work_on) {
    add_parallel("pricing/" + work + "/software",
                 [=](auto& state) { price(state, work_on, nullptr); });
    add_parallel("pricing/" + work + "/egl", [=](auto& state) { price_on_device(state, work_on); });
  };
  add_both("edges", analyze_edges);
  add_both("regions", analyze_regions);
  add_parallel("pricing/edges/left-to-the-cores", describe);
}

}  // namespace gradmesh::bench
