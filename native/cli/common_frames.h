#pragma once

#include <utility>

#include "document/document.h"

namespace gradmesh {

/// A mesh of a document, which must outlive this.
struct SeenMesh {
  const Document* document = nullptr;
  MeshEntry entry;
  Mesh mesh;

  Affine view() const { return document->view(entry); }
};

/// Frames of one size in which two meshes are painted to be compared, `resolution` pixels along the
/// longer side of the first. Two documents of one kind share their coordinates. Where the kinds
/// differ, one mesh is laid on the other.
std::pair<Frame, Frame> common_frames(const SeenMesh& a, const SeenMesh& b, int resolution);

}  // namespace gradmesh
