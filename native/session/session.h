#pragma once

#include "session/hands.h"
#include "session/protection.h"
#include "session/shown_mesh.h"

namespace gradmesh {

/// One mesh, and what a person makes of it by eye: goes along curves, merges and splits by hand,
/// takes back. All that it shows is measured as it will be written. Not thread-safe; curves are
/// searched for in the background.
class Session {
 public:
  /// `problem` has the mesh as it is and the picture that counts; its bounds do not count. Throws
  /// InputError if the mesh covers no pixel.
  explicit Session(const Problem& problem) : shown_(problem), hands_(shown_), protection_(shown_) {}

  const ShownMesh& shown() const { return shown_; }
  const Mesh& mesh() const { return shown_.mesh(); }
  CurveSearch& curves() const { return shown_.curves(); }
  /// Returns the search for what can be found out about the mesh that is shown.
  AnalysisSearch& analyses() { return shown_.analyses(hands_.fits()); }

  /// Shows a state of a curve, which is that of the mesh as it was edited by hand last: what was
  /// made there is from then on what counts. As long as `moves_on` is true, it is no step that can
  /// be taken back. Throws std::invalid_argument if there is no such state.
  void show(MeshKind kind, int state, bool moves_on);

  Hands& hands() { return hands_; }
  const Hands& hands() const { return hands_; }
  Protection& protection() { return protection_; }

  const History& history() const { return shown_.history(); }
  /// Take back and make again; nothing where there is nothing.
  void undo() { shown_.undo(); }
  void redo() { shown_.redo(); }

 private:
  ShownMesh shown_;
  Hands hands_;
  Protection protection_;
};

}  // namespace gradmesh
