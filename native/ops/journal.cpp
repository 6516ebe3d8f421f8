#include "ops/journal.h"

#include <algorithm>

namespace gradmesh {

void Journal::begin() {
  Operation& op = operations_.emplace_back();
  const auto count = [this]<class Record>(Before<Record>& before) {
    before.size = records<Record>().size();
  };
  std::apply([&](auto&... before) { (count(before), ...); }, op.before);
  op.face_count = mesh_.face_count_;
  ++stamp_;
}

void Journal::undo() {
  const Operation& op = operations_.back();
  const auto restore = [this]<class Record>(const Before<Record>& before) {
    records<Record>().resize(before.size);
    for (const auto& [element, record] : before.saved)
      records<Record>()[std::size_t(element.value)] = record;
  };
  std::apply([&](const auto&... before) { (restore(before), ...); }, op.before);
  mesh_.face_count_ = op.face_count;
  operations_.pop_back();
  // Stamps of the operation taken back must not hide what the one before it has not saved.
  ++stamp_;
}

std::vector<Face> Journal::touched_since(std::size_t depth) const {
  std::vector<Face> faces;
  for (std::size_t i = depth; i < operations_.size(); ++i)
    faces.insert(faces.end(), operations_[i].touched.begin(), operations_[i].touched.end());
  std::ranges::sort(faces);
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

bool Journal::mark(std::vector<std::uint64_t>& stamps, std::size_t i) {
  if (i >= stamps.size()) stamps.resize(i + 1, 0);
  if (stamps[i] == stamp_) return false;
  stamps[i] = stamp_;
  return true;
}

void Journal::touch(Face face) {
  if (mark(touched_in_, std::size_t(face.value))) operations_.back().touched.push_back(face);
}

void Journal::touch_curve(Halfedge curve) {
  for (const Halfedge side : {curve, mesh_[curve].twin})
    if (side.valid())
      for (const Halfedge leaf : mesh_.leaves(side)) touch(mesh_.face(leaf));
}

}  // namespace gradmesh
