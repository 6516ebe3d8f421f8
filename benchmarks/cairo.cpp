/// A peer: cairo's rasterizer of mesh patterns, which is also Inkscape's, on the same patches.
#include <cairo.h>

#include "bilinear.h"
#include "cases.h"

namespace gradmesh::bench {
namespace {

glm::dvec2 pixel(const Value& v, const Frame& frame) { return frame.to_pixels.point(v.position); }

void add_patch(cairo_pattern_t* pattern, const Patch& patch, const Frame& frame) {
  const BezierNet b = bezier_net(patch);
  const auto point = [&](int i, int j) { return pixel(b[i][j], frame); };
  const auto curve_to = [&](glm::dvec2 p, glm::dvec2 q, glm::dvec2 r) {
    cairo_mesh_pattern_curve_to(pattern, p.x, p.y, q.x, q.y, r.x, r.y);
  };
  cairo_mesh_pattern_begin_patch(pattern);
  cairo_mesh_pattern_move_to(pattern, point(0, 0).x, point(0, 0).y);
  curve_to(point(0, 1), point(0, 2), point(0, 3));
  curve_to(point(1, 3), point(2, 3), point(3, 3));
  curve_to(point(3, 2), point(3, 1), point(3, 0));
  curve_to(point(2, 0), point(1, 0), point(0, 0));
  const glm::dvec2 inner[] = {point(1, 1), point(1, 2), point(2, 2), point(2, 1)};
  for (int k = 0; k < 4; ++k) {
    cairo_mesh_pattern_set_control_point(pattern, k, inner[k].x, inner[k].y);
    const glm::dvec4 color = patch.corner(k).color;
    cairo_mesh_pattern_set_corner_color_rgb(pattern, k, color.r, color.g, color.b);
  }
  cairo_mesh_pattern_end_patch(pattern);
}

/// The pattern is made beforehand, in cairo's favour.
void paint(benchmark::State& state, const MeshFile& file) {
  const Input input(file);
  const Mesh mesh = bilinear(input.mesh);
  const Frame frame = input.frame(700);
  cairo_pattern_t* pattern = cairo_pattern_create_mesh();
  for (const Face face : mesh.faces()) add_patch(pattern, mesh.patch(face), frame);
  cairo_surface_t* surface =
      cairo_image_surface_create(CAIRO_FORMAT_ARGB32, frame.width, frame.height);
  cairo_t* context = cairo_create(surface);
  for (auto _ : state) {
    cairo_set_source_rgb(context, 1, 1, 1);
    cairo_paint(context);
    cairo_set_source(context, pattern);
    cairo_paint(context);
    benchmark::ClobberMemory();
  }
  if (cairo_status(context) != CAIRO_STATUS_SUCCESS)
    state.SkipWithError(cairo_status_to_string(cairo_status(context)));
  state.counters["patches"] = mesh.face_count();
  cairo_destroy(context);
  cairo_surface_destroy(surface);
  cairo_pattern_destroy(pattern);
}

}  // namespace

void register_cairo() {
  for (const char* name : {"duck", "banana"})
    add(std::string("cairo/paint/") + name, on(mesh_file(name), paint));
}

}  // namespace gradmesh::bench
