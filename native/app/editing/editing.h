#pragma once

#include <memory>

#include "app/document/document.h"
#include "app/runs/price_files.h"
#include "app/runs/runs.h"
#include "geom/box.h"
#include "session/session.h"

namespace gradmesh {

/// A session over one mesh of a document, which stays as it is until the session is written.
struct Editing {
  MeshEntry entry;
  std::unique_ptr<PriceFiles> files;
  /// The map from mesh units to what the person sees.
  Affine view;
  /// The number of objects that paint the mesh as it is.
  int objects_before;
  Session session;

  /// Returns what the mesh as it was at first takes of what the person sees.
  Box box() const;
  /// Returns the number of objects that will paint the mesh as it is shown.
  int objects() const {
    return session.shown().is_unchanged() ? objects_before
                                          : session.shown().now().form.object_count();
  }
};

/// Returns a session over a mesh. Of the options those count that say what is measured and how.
/// Throws as problem_of() and Session do, with InputErrors that name the mesh.
std::unique_ptr<Editing> edit_by_eye(const Document& document, const MeshEntry& entry,
                                     const RunOptions& options);

/// Writes what a session shows into its document, exactly as `gradmesh simplify --state` writes a
/// state. Returns what became of the mesh, which stays as it is if nothing was changed.
MeshReport write_shown(Document& document, const Editing& editing, const WriteOptions& writing);

}  // namespace gradmesh
