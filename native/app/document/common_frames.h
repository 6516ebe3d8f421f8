#pragma once

#include <utility>

#include "app/document/document.h"

namespace gradmesh {

/// A mesh of a document, which must outlive the SeenMesh.
struct SeenMesh {
  const Document* document = nullptr;
  MeshEntry entry;
  Mesh mesh;

  Affine view() const { return document->view(entry); }
};

/// Returns the mesh of `other` that corresponds to a mesh of `document`: the one with the same id
/// or, if `only`, the only one that there is. Throws InputError naming `other` if there is none.
MeshEntry counterpart(const Document& document, const MeshEntry& entry, const Document& other,
                      bool only);

/// Returns the map from the units of the mesh `b` to those of `a`. Two documents of one format
/// share their coordinates. If the formats differ, one mesh is laid on the other by the boxes
/// around them.
Affine onto(const SeenMesh& a, const SeenMesh& b);

/// Returns frames of one size in which two meshes are painted to be compared, `resolution` pixels
/// along the longer side of the first.
std::pair<Frame, Frame> common_frames(const SeenMesh& a, const SeenMesh& b, int resolution);

/// Returns the frame in which `document` paints a mesh so that its picture can be laid on the
/// picture that `other` paints of the mesh's counterpart.
Frame framed_as(const Document& other, const Document& document, const MeshEntry& entry,
                int resolution);

}  // namespace gradmesh
