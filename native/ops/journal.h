#pragma once

#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "mesh/mesh.h"

namespace gradmesh {

/// The only way to change a mesh. An operation edits records through the journal, which keeps each
/// record as it was, so that operations can be undone, the last first, at the cost of what they
/// touched. The kept records lie on stacks whose memory is used again after an undo.
class Journal {
 public:
  explicit Journal(Mesh& mesh) : mesh_(mesh) {}

  const Mesh& mesh() const { return mesh_; }

  /// Starts an operation: all edits up to the next begin() belong to it.
  void begin();
  /// Undoes the last operation. There must be at least one.
  void undo();
  /// Takes operations back until `depth` of them are left.
  void undo_to(std::size_t depth) {
    while (this->depth() > depth) undo();
  }
  /// Returns the number of operations that can be undone.
  std::size_t depth() const { return operations_.size(); }
  /// Makes all operations final: none of them can be undone any more.
  void forget();

  /// Returns the faces whose patch, or whose neighbours along a side, changed in the operations
  /// after the first `depth`, including faces that they removed; each once, in rising order.
  std::vector<Face> touched_since(std::size_t depth) const;

  // --- for operations ---
  template <class Record>
  Record& edit(Index<Record> element) {
    const auto i = std::size_t(element.value);
    Record& record = records<Record>()[i];
    auto& saved = std::get<Saved<Record>>(saved_);
    const bool is_new = i >= std::get<Before<Record>>(operations_.back().before).size;
    if (!is_new && mark(saved.stamps, i)) saved.records.emplace_back(element, record);
    return record;
  }
  template <class Record>
  Index<Record> add(Record record) {
    records<Record>().push_back(record);
    return {int(records<Record>().size()) - 1};
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
  /// Marks the faces along both sides of a curve as touched.
  void touch_curve(Halfedge curve);

 private:
  /// Records of one kind, each as it was before an operation edited it.
  template <class Record>
  struct Saved {
    std::vector<std::pair<Index<Record>, Record>> records;
    /// For each slot, the last operation that saved it.
    std::vector<std::uint64_t> stamps;
  };
  /// For one kind, the number of records in the mesh and of records saved when an operation began.
  /// Without values by default, for which Clang 19 finds the tuple of these to have no constructor.
  template <class Record>
  struct Before {
    std::size_t size, saved;
  };
  template <template <class> class Of>
  using ForEachKind =
      std::tuple<Of<PointRecord>, Of<HandleRecord>, Of<FaceRecord>, Of<HalfedgeRecord>>;

  struct Operation {
    ForEachKind<Before> before;
    int face_count;
    std::size_t touched;
  };

  template <class Record>
  std::vector<Record>& records() {
    if constexpr (std::is_same_v<Record, PointRecord>) return mesh_.points_;
    if constexpr (std::is_same_v<Record, HandleRecord>) return mesh_.handles_;
    if constexpr (std::is_same_v<Record, FaceRecord>) return mesh_.faces_;
    if constexpr (std::is_same_v<Record, HalfedgeRecord>) return mesh_.halfedges_;
  }

  /// Marks slot i. Returns true the first time that it is marked in this operation.
  bool mark(std::vector<std::uint64_t>& stamps, std::size_t i) {
    if (i >= stamps.size()) stamps.resize(i + 1, 0);
    if (stamps[i] == stamp_) return false;
    stamps[i] = stamp_;
    return true;
  }

  Mesh& mesh_;
  std::vector<Operation> operations_;
  std::uint64_t stamp_ = 0;
  ForEachKind<Saved> saved_;
  /// Faces that the operations touched, each once for an operation, and, for each face, the last
  /// operation that touched it.
  std::vector<Face> touched_;
  std::vector<std::uint64_t> touched_in_;
};

}  // namespace gradmesh
