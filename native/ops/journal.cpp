#include "ops/journal.h"

namespace gradmesh {

void Journal::begin() {
  operations_.push_back({});
  Operation& op = operations_.back();
  op.sizes = {mesh_.points_.size(), mesh_.handles_.size(), mesh_.faces_.size(),
              mesh_.halfedges_.size()};
  op.face_count = mesh_.face_count_;
  ++stamp_;
}

void Journal::undo() {
  Operation& op = operations_.back();
  const auto restore = [](auto& records, const auto& saved, std::size_t size) {
    records.resize(size);
    for (const auto& [element, record] : saved) records[element.value] = record;
  };
  restore(mesh_.points_, op.points, op.sizes[0]);
  restore(mesh_.handles_, op.handles, op.sizes[1]);
  restore(mesh_.faces_, op.faces, op.sizes[2]);
  restore(mesh_.halfedges_, op.halfedges, op.sizes[3]);
  mesh_.face_count_ = op.face_count;
  operations_.pop_back();
  // Stamps of the operation taken back must not hide what the one before it has not saved.
  ++stamp_;
}

bool Journal::mark(std::vector<std::uint64_t>& stamps, std::size_t i) {
  if (i >= stamps.size()) stamps.resize(i + 1, 0);
  if (stamps[i] == stamp_) return false;
  stamps[i] = stamp_;
  return true;
}

void Journal::touch(Face face) {
  if (mark(stamps_[4], std::size_t(face.value))) operations_.back().touched.push_back(face);
}

void Journal::touch_curve(Halfedge curve) {
  for (const Halfedge side : {curve, mesh_[curve].twin})
    if (side.valid())
      for (const Halfedge leaf : mesh_.leaves(side)) touch(mesh_.face(leaf));
}

}  // namespace gradmesh
