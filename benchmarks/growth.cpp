/// How cost grows: with patches, where each keeps its size in pixels, and with pixels. The last
/// part of a name is the number of patches or the resolution.
#include "app/pages/read_document.h"
#include "block_mesh.h"
#include "cases.h"
#include "raster/rasterizer.h"

namespace gradmesh::bench {
namespace {

constexpr int pixels_per_patch = 25;
constexpr int block_counts[] = {1, 2, 3, 4, 6, 8};
constexpr int resolutions[] = {350, 500, 700, 1000, 1400};

/// gqe on all cores.
void patches(benchmark::State& state, int blocks) {
  const Mesh start = block_mesh(blocks);
  RunOptions options;
  options.resolution = pixels_per_patch * block_side * blocks;
  SimplifyResult result;
  for (auto _ : state) {
    Mesh mesh = start;
    result = simplify(mesh, options);
  }
  count(state, result);
}

void gqe(benchmark::State& state, int resolution) {
  const MeshFile pear = mesh_file("pear");
  const auto document = read_document(pear.path);
  RunOptions options;
  options.resolution = resolution;
  SimplifyResult result;
  for (auto _ : state) result = preview(*document, {pear.id}, options).front().result;
  count(state, result);
}

void paint(benchmark::State& state, int resolution) {
  const Input pear(mesh_file("pear"));
  const Frame frame = pear.frame(resolution);
  const auto rasterizer = make_software_rasterizer();
  for (auto _ : state) benchmark::DoNotOptimize(rasterizer->paint(pear.mesh, frame));
}

void score(benchmark::State& state, MetricKind kind, int resolution) {
  const auto [reference, test] = image_pair(resolution, resolution);
  const auto metric = make_metric(kind, reference);
  for (auto _ : state) benchmark::DoNotOptimize(mean(metric->map(test)));
}

}  // namespace

void register_growth() {
  for (const int blocks : block_counts) {
    const int side = blocks * block_side;
    add_parallel("growth/gqe/patches/" + std::to_string(side * side),
                 [=](auto& state) { patches(state, blocks); });
  }
  for (const int resolution : resolutions) {
    const std::string size = "/resolution/" + std::to_string(resolution);
    add("growth/paint" + size, [=](auto& state) { paint(state, resolution); });
    for (const MetricKind kind : {MetricKind::ssim, MetricKind::flip})
      add(std::string("growth/") + name(kind) + size,
          [=](auto& state) { score(state, kind, resolution); });
    add_parallel("growth/gqe" + size, [=](auto& state) { gqe(state, resolution); });
  }
}

}  // namespace gradmesh::bench
