// What a person waits for in the window of simplifying by eye, at 1400 x 1000 pixels, over the
// photo of 400 patches with lines and handles. No display is needed.
#include "cases.h"
#include "screen.h"

namespace gradmesh::bench {
namespace {

struct OpenEye {
  OpenEye()
      : input(mesh_file("photo")),
        eye({"photo"},
            [this](const std::string&) { return edit_by_eye(*input.document, input.entry, {}); }),
        screen(eye, 1400, 1000, [](const std::string& text) { return text; }) {
    eye.session().curves().wait();
    eye.looks.handles = true;
    screen.settle();
  }

  Input input;
  Eye eye;
  test::Screen screen;
};

/// Returns the window over the mesh as it is, which takes long to open: benchmarks share it.
OpenEye& opened() {
  static OpenEye c;
  c.eye.attempt([](Session& session) {
    session.hands().set_form(MeshKind::one_gradient);
    session.show(MeshKind::one_gradient, 0, false);
  });
  c.screen.settle();
  return c;
}

/// A frame in which nothing has changed: panel, letters, the picture that is there.
void frame(benchmark::State& state) {
  OpenEye& c = opened();
  for (auto _ : state) c.screen.frame();
}

/// A frame in which the picture has moved by a pixel, so that it is painted anew.
void picture(benchmark::State& state) {
  OpenEye& c = opened();
  double by = 1;
  for (auto _ : state) {
    c.eye.viewport().pan({by = -by, 0});
    c.screen.frame();
  }
}

/// The slider moves to another state, and its picture is there.
void slider(benchmark::State& state) {
  OpenEye& c = opened();
  int to = 0;
  const int last = int(c.eye.curve()->curve.states.size()) - 1;
  for (auto _ : state) {
    to = to % last + 1;
    c.eye.slide(to, true);
    c.screen.frame();
  }
}

/// The pointer comes to another line of one gradient, or edge of blocks, and the picture without it
/// is there.
void pointing(benchmark::State& state, MeshKind form) {
  OpenEye& c = opened();
  c.eye.attempt([&](Session& session) { session.hands().set_form(form); });
  const Mesh& mesh = c.eye.session().mesh();
  std::vector<glm::dvec2> places;
  for (const Halfedge curve : mesh.curves())
    if (mesh[curve].twin.valid())
      places.push_back(c.eye.to_pixels().point(mesh.curve_of(curve).at(0.5).position));
  std::size_t next = 0;
  for (auto _ : state) {
    // Far from the one before.
    next = (next + 97) % places.size();
    c.screen.move(places[next]);
    if (!c.eye.session().hands().proposal()) state.SkipWithError("nothing was pointed at");
  }
}

}  // namespace

void register_window() {
  const auto add = [](const char* name, const Run& run) {
    benchmark::RegisterBenchmark(name, run)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
  };
  add("Window/frame", frame);
  add("Window/picture", picture);
  add("Window/slider", slider);
  add("Window/line", [](benchmark::State& s) { pointing(s, MeshKind::one_gradient); });
  add("Window/edge", [](benchmark::State& s) { pointing(s, MeshKind::blocks); });
}

}  // namespace gradmesh::bench
