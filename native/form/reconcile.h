#pragma once

#include "mesh/parts.h"

namespace gradmesh {

struct Reconciled {
  MeshParts parts;
  /// True if anything was moved or recoloured, beyond the rounding of whoever wrote it.
  bool edited = false;
};

/// Makes patches fit together again that a person may have edited one by one since they were
/// `written`: each patch holds copies of the points, handles and colours that it shares. Both
/// meshes are `bilinear` and have as many patches and equal curves.
///   - Of the copies of a point, a handle or a colour the one that moved farthest wins, and stays
///     where it was put. Copies that were not moved stay too, but handles follow their point where
///     their own patches were left alone.
///   - A T-junction lies on its curve, whose handles are taken from the patch on its long side. One
///     that was moved goes to the nearest place on the curve between its neighbours there; handles
///     of the curves that start at it follow it.
///   - A patch that is a Coons patch as read stays one.
/// If nothing was edited, the parts are as read. Throws InputError as build_mesh.
Reconciled reconcile(const MeshParts& read, const MeshParts& written);

/// Returns reconcile() of a mesh of which it is not known how it was written: of several copies the
/// first counts as unmoved.
Reconciled reconcile(const MeshParts& read);

}  // namespace gradmesh
