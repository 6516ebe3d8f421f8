#include "raster/edit_tile.h"

#include <algorithm>

#include "raster/segments.h"

namespace gradmesh {
namespace {

void copy(const Bicubic<float>& from, float* to) {
  for (const auto& row : from) to = std::ranges::copy(row, to).out;
}

TilePatch tile_patch(Face face, const Refinement& refinement, const PatchColor& color) {
  TilePatch patch = {};
  for (int axis = 0; axis < 2; ++axis) copy(refinement.position[axis], patch.position[axis]);
  for (int channel = 0; channel < 4; ++channel) copy(color.channels[channel], patch.color[channel]);
  copy(refinement.most, patch.most);
  std::ranges::copy(refinement.start_u, patch.start_u);
  std::ranges::copy(refinement.start_v, patch.start_v);
  patch.x = refinement.x;
  patch.y = refinement.y;
  patch.number = std::uint32_t(face.value) + 1;
  patch.flags = (color.bilinear ? TilePatch::bilinear : 0) |
                (color.opaque ? TilePatch::opaque : 0) |
                (color.masked_opacity ? TilePatch::masked_opacity : 0);
  return patch;
}

void add_span(Window row, int x0, int x1, int parameters, EditTile& tile) {
  const int from = std::max(x0, row.x0), to = std::min(x1, row.x1);
  if (from >= to) return;
  const int first = (from - x0) / most_length, end = (to - 1 - x0) / most_length + 1;
  tile.spans.push_back(
      {int(tile.patches.size()) - 1, row.y0, x0, x1, first, tile.segments, parameters});
  tile.segments += end - first;
}

}  // namespace

void EditTile::reset(Window to) {
  window = to;
  touched.clear();
  patches.clear();
  spans.clear();
  parameters.clear();
  segments = 0;
}

void EditTiler::make(const Mesh& mesh, const Frame& frame, const std::vector<Face>& touched,
                     Window within, const Painting* painting, EditTile& tile) {
  within = within.clipped(frame.window());
  tile.reset(within);
  if (within.empty()) return;
  for (const Face f : touched) tile.touched.push_back(std::uint32_t(f.value) + 1);
  const auto is_touched = [&](Face f) {
    return std::ranges::binary_search(tile.touched, std::uint32_t(f.value) + 1);
  };
  tessellator_.start(mesh, frame);
  for (const Face f : touched)
    if (std::size_t(f.value) < mesh.face_slots() && mesh[f].alive)
      add_face(mesh, frame, f, within, tile);
  if (!painting) return;
  Window uncovered;
  for_each_run(painting->top, within, [&](Window run, TopFace top) {
    if (top.covers_others() && is_touched(top.face())) uncovered = uncovered.united(run);
  });
  if (!uncovered.empty())
    for (const Face f : mesh.faces())
      if (!is_touched(f)) add_face(mesh, frame, f, uncovered, tile);
}

void EditTiler::make_whole(const Mesh& mesh, const Frame& frame, Window window, EditTile& tile) {
  tile.reset(window);
  tessellator_.start(mesh, frame);
  for (const Face f : mesh.faces()) add_face(mesh, frame, f, window, tile);
}

void EditTiler::add_face(const Mesh& mesh, const Frame& frame, Face face, Window window,
                         EditTile& tile) {
  const Patch patch = painted_patch(mesh, frame, face);
  tessellator_.tessellate(face, patch, window, shape_);
  const Window seen = shape_.bounds.clipped(window);
  if (seen.empty()) return;
  const PatchColor color(patch, mesh.color_model(), frame.masked_opacity);
  tile.patches.push_back(tile_patch(face, shape_.refinement, color));
  if (shape_.traced)
    add_traced(window, tile);
  else
    add_found(window, tile);
}

void EditTiler::add_traced(Window window, EditTile& tile) const {
  const auto above = [](const Span& span, int y) { return span.y < y; };
  auto span = std::lower_bound(shape_.spans.begin(), shape_.spans.end(), window.y0, above);
  for (; span != shape_.spans.end() && span->y < window.y1; ++span)
    add_span({window.x0, span->y, window.x1, span->y + 1}, span->x0, span->x1, -1, tile);
}

void EditTiler::add_found(Window window, EditTile& tile) {
  find_parameters(shape_, window, parameters_);
  const Window found = parameters_.window;
  for (int y = found.y0; y < found.y1; ++y) {
    const std::size_t at = parameters_.offset(found.x0, y), first = tile.parameters.size();
    const float *u = &parameters_.u[at], *v = &parameters_.v[at];
    const int width = found.width();
    int x0 = 0, x1 = width;
    while (x0 < x1 && u[x0] < 0) ++x0;
    while (x0 < x1 && u[x1 - 1] < 0) --x1;
    for (int x = x0; x < x1; ++x) tile.parameters.insert(tile.parameters.end(), {u[x], v[x]});
    add_span({found.x0, y, found.x1, y + 1}, found.x0 + x0, found.x0 + x1, int(first / 2), tile);
  }
}

}  // namespace gradmesh
