#include "app/document/frames.h"

#include <algorithm>

#include "formats/text/excerpt.h"
#include "mesh/boundary.h"

namespace gradmesh {
namespace {

/// Returns the map that lays the second mesh on the first, as both are seen: the boxes then share
/// their corner of least x and y, and their longer sides are equal.
Affine aligned(const MeshInDocument& a, const MeshInDocument& b) {
  const Box to = bounding_box(a.mesh, a.view()), from = bounding_box(b.mesh, b.view());
  const double scale = std::max(to.size().x, to.size().y) / std::max(from.size().x, from.size().y);
  return Affine::translation(to.low()) * Affine::scaling(glm::dvec2(scale)) *
         Affine::translation(-from.low());
}

Frame moved(Frame frame, const Affine& from_mesh) {
  frame.to_pixels = frame.to_pixels * from_mesh;
  return frame;
}

}  // namespace

Frame frame_of(const MeshSource& document, const MeshEntry& entry, const Mesh& mesh,
               int resolution) {
  const Affine seen = document.view(entry);  // Names the element itself.
  return document.naming(entry,
                         [&] { return fit_frame(mesh, seen, resolution, document.padding()); });
}

Layout layout_of(const MeshSource& document, const MeshEntry& entry, bool visible_only) {
  return {document.view(entry), document.padding(),
          visible_only ? document.visible_area(entry) : std::nullopt};
}

MeshEntry counterpart(const MeshSource& document, const MeshEntry& entry, const MeshSource& other,
                      bool only) {
  const std::vector<MeshEntry> entries = other.selected({});
  if (only && entries.size() == 1) return entries.front();
  for (const MeshEntry& e : other.meshes())
    if (e.id == entry.id && e.role == entry.role) return e;
  // What simplify makes of a fill and a stroke in blocks has one role, whatever it was.
  for (const MeshEntry& e : other.meshes())
    if (e.id == entry.id) return e;
  throw InputError("{0}: there is no mesh with the id {1}, which {2} has.", other.name(),
                   excerpt(entry.id), document.name());
}

Affine onto(const MeshInDocument& a, const MeshInDocument& b) {
  const bool same_format = a.document->format() == b.document->format();
  return a.view().inverse() * (same_format ? b.view() : aligned(a, b) * b.view());
}

std::pair<Frame, Frame> common_frames(const MeshInDocument& a, const MeshInDocument& b,
                                      int resolution) {
  const bool same_format = a.document->format() == b.document->format();
  const Frame first = same_format ? frame_of(*a.document, a.entry, a.mesh, resolution)
                                  : fit_frame(a.mesh, a.view(), resolution);
  return {first, moved(first, onto(a, b))};
}

Frame framed_as(const MeshSource& other, const MeshSource& document, const MeshEntry& entry,
                int resolution) {
  const MeshEntry match = counterpart(document, entry, other, true);
  const MeshInDocument a{&other, match, other.mesh(match)},
      b{&document, entry, document.mesh(entry)};
  return moved(frame_of(other, match, a.mesh, resolution), onto(a, b));
}

}  // namespace gradmesh
