#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "mesh/mesh.h"

namespace gradmesh {

/// The only way to change a mesh. An operation edits records through the journal, which keeps
/// each as it was, so that operations can be undone, the last first, at the cost of what they
/// touched.
class Journal {
 public:
  explicit Journal(Mesh& mesh) : mesh_(mesh) {}

  const Mesh& mesh() const { return mesh_; }

  /// Starts an operation: all edits up to the next begin() belong to it.
  void begin();
  /// Takes the last operation back. At least one must be kept.
  void undo();
  /// How many operations can be undone.
  std::size_t depth() const { return operations_.size(); }
  /// Keeps all that was done for good.
  void forget() { operations_.clear(); }

  /// Faces whose patch, or whose neighbours along a side, the last operation changed, those it
  /// removed among them; each once, in no particular order.
  const std::vector<Face>& touched() const { return operations_.back().touched; }

  // --- for operations ---
  template <class Record>
  Record& edit(Index<Record> element) {
    return save(element, table<Record>());
  }
  template <class Record>
  Index<Record> add(Record record) {
    auto& records = *table<Record>().records;
    records.push_back(record);
    return {int(records.size()) - 1};
  }
  template <class Record>
  void remove(Index<Record> element) {
    edit(element).alive = false;
  }
  Face add_face(FaceRecord record) {
    ++mesh_.face_count_;
    return add(record);
  }
  void remove_face(Face face) {
    --mesh_.face_count_;
    remove(face);
    touch(face);
  }
  void touch(Face face);
  /// The faces along both sides of a curve.
  void touch_curve(Halfedge curve);

 private:
  template <class Record>
  using Saved = std::vector<std::pair<Index<Record>, Record>>;

  struct Operation {
    Saved<PointRecord> points;
    Saved<HandleRecord> handles;
    Saved<FaceRecord> faces;
    Saved<HalfedgeRecord> halfedges;
    std::array<std::size_t, 4> sizes;
    int face_count;
    std::vector<Face> touched;
  };

  template <class Record>
  struct Table {
    std::vector<Record>* records;
    Saved<Record>* saved;
    std::vector<std::uint64_t>* stamps;
    std::size_t size_before;
  };
  template <class Record>
  Table<Record> table();

  template <class Record>
  Record& save(Index<Record> element, Table<Record> table) {
    const std::size_t i = std::size_t(element.value);
    if (i < table.size_before && mark(*table.stamps, i))
      table.saved->emplace_back(element, (*table.records)[i]);
    return (*table.records)[i];
  }

  /// True the first time that slot i is marked in this operation.
  bool mark(std::vector<std::uint64_t>& stamps, std::size_t i);

  Mesh& mesh_;
  std::vector<Operation> operations_;
  std::uint64_t stamp_ = 0;
  std::array<std::vector<std::uint64_t>, 5> stamps_;
};

template <>
inline Journal::Table<PointRecord> Journal::table() {
  Operation& op = operations_.back();
  return {&mesh_.points_, &op.points, &stamps_[0], op.sizes[0]};
}
template <>
inline Journal::Table<HandleRecord> Journal::table() {
  Operation& op = operations_.back();
  return {&mesh_.handles_, &op.handles, &stamps_[1], op.sizes[1]};
}
template <>
inline Journal::Table<FaceRecord> Journal::table() {
  Operation& op = operations_.back();
  return {&mesh_.faces_, &op.faces, &stamps_[2], op.sizes[2]};
}
template <>
inline Journal::Table<HalfedgeRecord> Journal::table() {
  Operation& op = operations_.back();
  return {&mesh_.halfedges_, &op.halfedges, &stamps_[3], op.sizes[3]};
}

}  // namespace gradmesh
