#pragma once

#include <array>
#include <vector>

#include "ops/journal.h"

namespace gradmesh {

/// A vector of a mesh that a fit may change.
struct Unknown {
  enum Kind {
    twist,    ///< of a face, at one of its corners
    tangent,  ///< of a curve, at one of its ends
  };
  Kind kind;
  /// Whether its colour part counts in the mesh's colour model.
  bool moves_color;
  /// twist: the half-edge that has it.
  Halfedge corner{};
  /// tangent: the curve as Mesh::curve names it, and which of its handles.
  Halfedge curve{};
  Handle handle{};
};

/// The unknowns of these faces: their twists, and the tangents of the curves on which their sides
/// lie. Points and the colours of corners stay: freeing these as well gains nothing
/// (docs/quality.md).
std::vector<Unknown> unknowns_of(const Mesh& mesh, const std::vector<Face>& faces);

/// Adds `by` to an unknown, as a part of the journal's operation; what hangs on it follows.
void change(Journal& journal, const Unknown& unknown, const Value& by);

/// How the control vectors of a patch change with an unknown, by row and column of Patch::c: their
/// places with its place, their colours with its colour. The mesh is linear in its unknowns.
struct Influence {
  /// Which of the unknowns.
  int unknown;
  std::array<double, 16> place, color;
};

/// A face and all that changes its patch.
struct InfluencedFace {
  Face face;
  std::vector<Influence> by;
};

/// The faces that the unknowns change, in rising order. The journal's mesh is as before, after.
std::vector<InfluencedFace> influences(Journal& journal, const std::vector<Unknown>& unknowns);

}  // namespace gradmesh
