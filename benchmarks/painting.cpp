#include "bilinear.h"
#include "cases.h"
#include "raster/rasterizer.h"

namespace gradmesh::bench {
namespace {

void paint(benchmark::State& state, const Mesh& mesh, const Frame& frame) {
  const auto rasterizer = make_software_rasterizer();
  for (auto _ : state) benchmark::DoNotOptimize(rasterizer->paint(mesh, frame));
  state.counters["patches"] = mesh.face_count();
}

}  // namespace

void register_painting() {
  for (const char* name : {"duck", "banana"}) {
    const MeshFile file = mesh_file(name);
    const std::string line = std::string("paint/") + name;
    add(line, on(file, [](auto& state, auto& f) {
          const Input input(f);
          paint(state, input.mesh, input.frame(700));
        }));
    add(line + "/corner-colors", on(file, [](auto& state, auto& f) {
          const Input input(f);
          paint(state, bilinear(input.mesh), input.frame(700));
        }));
  }
}

}  // namespace gradmesh::bench
