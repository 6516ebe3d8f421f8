#pragma once

#include <vector>

#include "base/error.h"
#include "base/message.h"
#include "mesh/mesh.h"
#include "problem/problem.h"
#include "session/pointing.h"

namespace gradmesh {

/// Thrown where a protected patch forbids an edit.
class PatchForbids : public InputError {
 public:
  PatchForbids(Face forbidding, const InputError& why) : InputError(why), face(forbidding) {}

  Face face;
};

/// What a person takes out of a mesh or puts into it by hand. In a mesh that is one gradient and
/// stays one, whole lines go and come; otherwise single patches are merged and split.
enum class HandEdit { merge, split_rows, split_columns, split_both };

/// An edit that can be made.
struct EditedMesh {
  Mesh mesh = {};
  /// What a menu calls it.
  Message name;
  /// The curves of the mesh before that go, and those of the mesh after that come.
  std::vector<Halfedge> gone = {}, come = {};
  /// The patch that others were merged to; invalid if there is none.
  Face merged = {};
  /// True if the picture is to be another one.
  bool redraws = false;
};

/// Throws InputError if the mesh is smooth: the colours of its patches follow from those around.
void check_has_own_colors(const Mesh& mesh);

/// Throws InputError if a patch that is protected differs after an edit that has left all faces
/// where they were.
void check_protected(const Mesh& before, const Mesh& after);

/// Returns for each line of points inside a mesh that is one grid the curves along it, those along
/// rows first.
std::vector<std::vector<Halfedge>> inner_lines(const Mesh& mesh);

/// Returns the mesh, which is one grid, without the line of points through an edge, or with lines
/// more through a place. If `fits` is true, the points around a line that is gone are fitted to the
/// picture of the problem. Throws InputError if there is no edge where there has to be one, and if
/// lines were to come in a smooth mesh.
EditedMesh edit_lines(const Mesh& mesh, const Pointed& pointed, HandEdit edit, bool fits,
                      const Problem& problem);

/// Returns the mesh with the two patches beside an edge merged, or with the patch at a place split.
/// Throws InputError if there is no edge where there has to be one, if the patches cannot be
/// merged, and if the mesh is smooth.
EditedMesh edit_patches(const Mesh& mesh, const Pointed& pointed, HandEdit edit);

/// Returns the mesh with these patches merged to one. Throws InputError if they cannot be, as in a
/// smooth mesh.
EditedMesh merged_patches(const Mesh& mesh, std::vector<Face> faces);

/// Returns the mesh fitted to the picture of the problem as far as its points, handles and colours
/// allow: a grid if `is_gradient` is true, otherwise these faces of any mesh.
Mesh fitted(const Mesh& mesh, bool is_gradient, const std::vector<Face>& faces,
            const Problem& problem);

}  // namespace gradmesh
