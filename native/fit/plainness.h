#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "ops/journal.h"

namespace gradmesh {

/// What is plain in a mesh of the model `bilinear`: sides that are straight, Coons patches, and
/// handles that lie in one line across a point. A fit that keeps it frees points instead, which
/// cost a person nothing.
class Plainness {
 public:
  /// Keeps nothing plain, and no point is free.
  Plainness() = default;
  explicit Plainness(const Mesh& mesh);

  /// True if a curve, as Mesh::curve names it, is straight.
  bool is_straight(Halfedge curve) const { return at(straight_, curve.value); }
  bool is_coons(Face face) const { return at(coons_, face.value); }
  /// True if a point may move: all but T-junctions, which follow their parents, and the points of
  /// outlines.
  bool is_free(Point point) const { return at(free_, point.value); }

  /// Keeps a straight curve no longer straight.
  void let_bend(Halfedge curve) { straight_.at(std::size_t(curve.value)) = false; }

  /// The handle beyond a handle's point that lies in one line with it, and its curve.
  struct Opposite {
    Halfedge curve;
    Handle handle;
  };
  std::optional<Opposite> opposite(Handle handle) const;

  /// Returns the curves that end at a point.
  const std::vector<Halfedge>& curves_at(Point point) const;

  /// Does what refresh() does, and makes straight and Coons again, as a part of the journal's
  /// operation, what depends on the changed curves and was so.
  void refresh(Journal& journal, std::span<const Halfedge> changed_curves) const;
  /// Makes Coons patches again, as a part of the journal's operation, of what was one of the faces
  /// that operations after the first `depth` touched.
  void keep_coons(Journal& journal, std::size_t depth) const;

 private:
  static bool at(const std::vector<bool>& set, int i) {
    return std::size_t(i) < set.size() && set[std::size_t(i)];
  }

  void pair_handles(const Mesh& mesh);

  std::vector<bool> straight_, coons_, free_;
  std::map<Point, std::vector<Halfedge>> curves_;
  std::map<Handle, Opposite> opposites_;
};

}  // namespace gradmesh
