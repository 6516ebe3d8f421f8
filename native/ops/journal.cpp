#include "ops/journal.h"

#include <algorithm>

namespace gradmesh {

void Journal::begin() {
  Operation& op = operations_.emplace_back();
  const auto count = [this]<class Record>(Before<Record>& before) {
    before = {records<Record>().size(), std::get<Saved<Record>>(saved_).records.size()};
  };
  std::apply([&](auto&... before) { (count(before), ...); }, op.before);
  op.face_count = mesh_.face_count_;
  op.touched = touched_.size();
  ++stamp_;
}

void Journal::undo() {
  const Operation& op = operations_.back();
  const auto restore = [this]<class Record>(const Before<Record>& before) {
    records<Record>().resize(before.size);
    auto& saved = std::get<Saved<Record>>(saved_).records;
    for (std::size_t i = saved.size(); i-- > before.saved;)
      records<Record>()[std::size_t(saved[i].first.value)] = saved[i].second;
    saved.resize(before.saved);
  };
  std::apply([&](const auto&... before) { (restore(before), ...); }, op.before);
  mesh_.face_count_ = op.face_count;
  touched_.resize(op.touched);
  operations_.pop_back();
  // Stamps of the operation taken back must not hide what the one before it has not saved.
  ++stamp_;
}

void Journal::forget() {
  operations_.clear();
  touched_.clear();
  std::apply([](auto&... saved) { (saved.records.clear(), ...); }, saved_);
}

std::vector<Face> Journal::touched_since(std::size_t depth) const {
  if (depth >= operations_.size()) return {};
  std::vector<Face> faces(touched_.begin() + std::ptrdiff_t(operations_[depth].touched),
                          touched_.end());
  std::ranges::sort(faces);
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

void Journal::touch(Face face) {
  if (mark(touched_in_, std::size_t(face.value))) touched_.push_back(face);
}

void Journal::touch_curve(Halfedge curve) {
  for (const Halfedge side : {curve, mesh_[curve].twin})
    if (side.valid())
      for (const Halfedge leaf : mesh_.leaves(side)) touch(mesh_.face(leaf));
}

}  // namespace gradmesh
