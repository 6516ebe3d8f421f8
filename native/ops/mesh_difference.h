#pragma once

#include <tuple>
#include <vector>

#include "mesh/mesh.h"

namespace gradmesh {

/// What makes one mesh of another, and that again of the first: the records that differ, so that a
/// history of many small edits is small.
class MeshDifference {
 public:
  MeshDifference(const Mesh& before, const Mesh& after);

  /// Make the one of the other, which `mesh` must be.
  void forward(Mesh& mesh) const { apply(mesh, true); }
  void back(Mesh& mesh) const { apply(mesh, false); }

  /// Returns about how many bytes it takes.
  std::size_t bytes() const;

 private:
  /// The places of one array at which records differ, in rising order, as far as both arrays have
  /// them; and the records of each, first those at these places and then all that only it has.
  template <class Record>
  struct Part {
    std::vector<std::size_t> places;
    std::vector<Record> before, after;
  };
  /// What is beside the arrays.
  struct Header {
    int face_count;
    ColorModel color_model;
    bool smooth;
  };

  void apply(Mesh& mesh, bool is_forward) const;
  template <class Record>
  static std::vector<Record>& records(Mesh& mesh);
  template <class Record>
  static const std::vector<Record>& records(const Mesh& mesh) {
    return records<Record>(const_cast<Mesh&>(mesh));
  }
  static Header header(const Mesh& mesh) {
    return {mesh.face_count_, mesh.color_model_, mesh.smooth_};
  }

  Header before_, after_;
  std::tuple<Part<PointRecord>, Part<HandleRecord>, Part<FaceRecord>, Part<HalfedgeRecord>> parts_;
};

}  // namespace gradmesh
