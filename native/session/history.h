#pragma once

#include <cstddef>
#include <vector>

#include "base/message.h"
#include "mesh/mesh.h"
#include "ops/mesh_difference.h"
#include "session/setting.h"

namespace gradmesh {

/// What was made of a mesh, step by step, as differences.
class History {
 public:
  History(Mesh mesh, Setting setting) : mesh_(std::move(mesh)), setting_(std::move(setting)) {}

  bool can_undo() const { return done_ > 0; }
  bool can_redo() const { return done_ < steps_.size(); }
  /// Return what a menu calls that which undo() takes back, and that which redo() does again; null
  /// if there is nothing.
  const Message* undo_name() const { return can_undo() ? &steps_[done_ - 1].name : nullptr; }
  const Message* redo_name() const { return can_redo() ? &steps_[done_].name : nullptr; }
  /// Returns about how many bytes it takes.
  std::size_t bytes() const;

  /// Records how a mesh and its setting differ from what mesh() and setting() are. Where they do
  /// not there is no step.
  void record(const Mesh& mesh, const Setting& setting, const Message& name);
  /// Go one step back or on. There must be one.
  void undo();
  void redo();
  /// Return what was recorded last, or gone back or on to.
  const Mesh& mesh() const { return mesh_; }
  const Setting& setting() const { return setting_; }

 private:
  struct Step {
    Message name;
    MeshDifference mesh;
    Setting before, after;
  };

  Mesh mesh_;
  Setting setting_;
  std::vector<Step> steps_;
  /// How many of the steps are not taken back.
  std::size_t done_ = 0;
};

}  // namespace gradmesh
