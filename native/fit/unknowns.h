#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "fit/plainness.h"
#include "ops/journal.h"

namespace gradmesh {

/// A vector of a mesh that a fit may change.
struct Unknown {
  enum Kind {
    twist,    ///< of a face, at one of its corners
    tangent,  ///< of a curve, at one of its ends
    place,    ///< of a point
  };
  Kind kind;
  /// True if the vector's colour part counts in the mesh's colour model.
  bool moves_color;
  /// twist: the half-edge that has it.
  Halfedge corner{};
  /// tangent: the curve as Mesh::curve names it, and which of its handles.
  Halfedge curve{};
  Handle handle{};
  /// tangent: the one in line with it, which then moves the other way, and how far the two move
  /// for a step of 1.
  std::optional<Plainness::Opposite> opposite{};
  double share = 1, opposite_share = 1;
  Point moved{};
};

/// Returns the unknowns of these faces: their twists, and the tangents of the curves on which their
/// sides lie, but those that would make what is plain less plain; and the points that are free.
/// Otherwise points and the colours of corners stay: freeing these as well gains nothing
/// (docs/development/tried.md).
std::vector<Unknown> unknowns_of(const Mesh& mesh, const std::vector<Face>& faces,
                                 const Plainness& plain = {});

/// Adds to each unknown what `by` has at its index, as a part of the journal's operation. What
/// depends on them follows: T-junctions, and what is plain (Plainness).
void change(Journal& journal, std::span<const Unknown> unknowns, std::span<const Value> by,
            const Plainness& plain = {});

/// How the control vectors of a patch change with an unknown, by row and column of Patch::c: their
/// places with its place, their colours with its colour. The mesh is linear in its unknowns.
struct Influence {
  /// Index of the unknown.
  int unknown;
  std::array<double, 16> place, color;
};

/// A face and the influences of all unknowns that change its patch.
struct InfluencedFace {
  Face face;
  std::vector<Influence> by;
};

/// Returns the faces that the unknowns change, in rising order. Leaves the journal's mesh as it
/// was.
std::vector<InfluencedFace> influences(Journal& journal, const std::vector<Unknown>& unknowns,
                                       const Plainness& plain = {});

}  // namespace gradmesh
