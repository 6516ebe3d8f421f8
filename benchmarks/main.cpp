/// The benchmarks, by Google Benchmark; its options choose among them. scripts/bench runs them.
///
///     gradmesh_bench [--benchmark_filter=REGEX] [...]
///     gradmesh_bench --image-pair FOLDER     writes the images that metrics are timed on, for
///     peers
#include <cstdio>
#include <string_view>

#include "base/error.h"
#include "cases.h"
#include "files/image_file.h"

namespace gradmesh::bench {
namespace {

void write_image_pair(const std::filesystem::path& folder) {
  const auto [reference, test] = image_pair(700, 700);
  write_png(reference, folder / "reference.png");
  write_png(test, folder / "test.png");
}

int run(int argc, char** argv) {
  if (argc == 3 && std::string_view(argv[1]) == "--image-pair") {
    write_image_pair(argv[2]);
    return 0;
  }
  register_painting();
#ifdef GRADMESH_HAS_CAIRO
  register_cairo();
#endif
  register_metrics();
  register_merges();
  register_assembly();
  register_methods();
  register_growth();
  register_pricing();
  register_traces();
#ifdef GRADMESH_WINDOW
  register_window();
#endif
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace
}  // namespace gradmesh::bench

int main(int argc, char** argv) {
  try {
    return gradmesh::bench::run(argc, argv);
  } catch (const gradmesh::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
