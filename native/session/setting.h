#pragma once

#include <memory>
#include <vector>

#include "mesh/mesh.h"
#include "reference/original.h"
#include "simplify/state_curve.h"

namespace gradmesh {

/// What the states of a curve are made of, and measured against.
struct Basis {
  /// The mesh as it was at first or as it was edited by hand last, with what is protected of it.
  std::shared_ptr<const Mesh> start;
  /// The picture at first, but as it was edited in the areas that were.
  std::shared_ptr<const Original> original;
  std::vector<FilledOutline> by_hand = {};
  /// True if an edit was there to change the picture.
  bool is_redrawn = false;
};

/// In what a mesh is shown: all that a session shows beside the mesh itself.
struct Setting {
  /// What the mesh is, and will be written as.
  MeshKind form;
  /// The state of the curve of that form; -1 if the mesh was edited by hand.
  int state;
  /// By what the mesh is measured, and of what the curve is. What is edited by hand is measured
  /// against the picture as it was, until a state of its curve is shown.
  std::shared_ptr<const Basis> basis, next;
  /// Where errors count more or less.
  std::shared_ptr<const std::vector<WeightedArea>> weighted;

  /// Returns true if what is measured, and how, is the same, whatever the state.
  bool is_like(const Setting& other) const {
    return form == other.form && basis == other.basis && next == other.next &&
           weighted == other.weighted;
  }
};

}  // namespace gradmesh
