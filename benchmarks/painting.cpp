#include "raster/painting.h"
#include "bilinear.h"
#include "cases.h"

namespace gradmesh::bench {
namespace {

/// Into the same memory each time, as cairo into its surface.
void paint(benchmark::State& state, const Mesh& mesh, const Frame& frame) {
  Painting painting(frame.window());
  for (auto _ : state) {
    paint_whole(mesh, frame, painting);
    benchmark::ClobberMemory();
  }
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
