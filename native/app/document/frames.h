#pragma once

#include <utility>

#include "app/document/mesh_source.h"
#include "problem/problem.h"
#include "raster/frame.h"

namespace gradmesh {

/// Returns the frame in which a mesh of a document is painted and measured.
Frame frame_of(const MeshSource& document, const MeshEntry& entry, const Mesh& mesh,
               int resolution);
/// Returns how a mesh is laid out on pictures. Leaves out what is visible of it if all of the mesh
/// counts.
Layout layout_of(const MeshSource& document, const MeshEntry& entry, bool visible_only);

/// A mesh of a document, which must outlive the MeshInDocument.
struct MeshInDocument {
  const MeshSource* document = nullptr;
  MeshEntry entry;
  Mesh mesh;

  Affine view() const { return document->view(entry); }
};

/// Returns the mesh of `other` that corresponds to a mesh of `document`: the one with the same id
/// or, if `only`, the only one that there is. Throws InputError naming `other` if there is none.
MeshEntry counterpart(const MeshSource& document, const MeshEntry& entry, const MeshSource& other,
                      bool only);

/// Returns the map from the units of the mesh `b` to those of `a`. Two documents of one format
/// share their coordinates. If the formats differ, one mesh is laid on the other by the boxes
/// around them.
Affine onto(const MeshInDocument& a, const MeshInDocument& b);

/// Returns frames of one size in which two meshes are painted to be compared, `resolution` pixels
/// along the longer side of the first.
std::pair<Frame, Frame> common_frames(const MeshInDocument& a, const MeshInDocument& b,
                                      int resolution);

/// Returns the frame in which `document` paints a mesh so that its picture can be laid on the
/// picture that `other` paints of the mesh's counterpart.
Frame framed_as(const MeshSource& other, const MeshSource& document, const MeshEntry& entry,
                int resolution);

}  // namespace gradmesh
