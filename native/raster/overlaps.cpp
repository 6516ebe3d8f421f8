#include "raster/overlaps.h"

#include <algorithm>
#include <set>

#include "raster/hidden.h"
#include "raster/painter.h"
#include "raster/painting.h"

namespace gradmesh {
namespace {

bool lies_over_itself(const Painting& painting) {
  return std::ranges::any_of(painting.top.samples,
                             [](std::uint32_t sample) { return TopFace(sample).covers_others(); });
}

}  // namespace

std::vector<Overlap> find_overlaps(const Mesh& mesh, const Frame& frame) {
  if (mesh.is_smooth() || !lies_over_itself(paint_whole(mesh, frame))) return {};
  std::set<Overlap> found;
  Painter painter;
  Painting alone(frame.window());
  Raster<std::uint32_t, 1> top(frame.window());
  for (const Face face : mesh.faces()) {
    const Window seen =
        pixel_bounds(painted_patch(mesh, frame, face), frame).clipped(frame.window());
    painter.paint_alone(mesh, frame, face, seen, alone);
    for_each_run(alone.top, seen, [&](Window run, TopFace) {
      for (int x = run.x0; x < run.x1; ++x) {
        const Face below = TopFace(*top.at(x, run.y0)).face();
        if (below.valid()) found.insert({below, face});
        *top.at(x, run.y0) = TopFace().with(face).sample();
      }
    });
  }
  return {found.begin(), found.end()};
}

}  // namespace gradmesh
