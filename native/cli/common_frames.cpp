#include "cli/common_frames.h"

#include <algorithm>

#include "mesh/boundary.h"

namespace gradmesh {
namespace {

/// Takes the second mesh to where the first one is, as both are seen: the same box, whose longer
/// sides agree.
Affine aligned(const SeenMesh& a, const SeenMesh& b) {
  const Box to = bounding_box(a.mesh, a.view()), from = bounding_box(b.mesh, b.view());
  const double scale = std::max(to.size().x, to.size().y) / std::max(from.size().x, from.size().y);
  return Affine::translation(to.low()) * Affine::scaling(glm::dvec2(scale)) *
         Affine::translation(-from.low());
}

}  // namespace

std::pair<Frame, Frame> common_frames(const SeenMesh& a, const SeenMesh& b, int resolution) {
  const bool same_kind = a.document->kind() == b.document->kind();
  const Frame first = same_kind ? a.document->frame(a.entry, a.mesh, resolution)
                                : fit_frame(a.mesh, a.view(), resolution);
  Frame second = first;
  const Affine onto_first = same_kind ? b.view() : aligned(a, b) * b.view();
  second.to_pixels = first.to_pixels * a.view().inverse() * onto_first;
  return {first, second};
}

}  // namespace gradmesh
