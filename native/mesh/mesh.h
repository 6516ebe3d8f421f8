#pragma once

#include <vector>

#include "geom/patch.h"
#include "mesh/elements.h"
#include "mesh/parts.h"
#include "mesh/ranges.h"

namespace gradmesh {

/// A gradient mesh with T-junctions: flat arrays of points, handles, faces and half-edges (paper
/// 2.1, 2.2). Everything here is const; a mesh is made by build_mesh and changed by ops/ alone.
/// Elements that an operation took out stay in the arrays, not alive, until the operation is
/// undone.
class Mesh {
 public:
  ColorModel color_model() const { return color_model_; }
  /// Returns true if the mesh, of the model `bilinear`, is painted with smooth colours between the
  /// corners, which follow the neighbours (SVG's type="bicubic", smooth_colors.h). The patches here
  /// do not have these colours.
  bool is_smooth() const { return smooth_; }

  const PointRecord& operator[](Point p) const { return points_[p.value]; }
  const HandleRecord& operator[](Handle h) const { return handles_[h.value]; }
  const FaceRecord& operator[](Face f) const { return faces_[f.value]; }
  const HalfedgeRecord& operator[](Halfedge h) const { return halfedges_[h.value]; }

  /// Return the elements that are alive, in the order of their indices.
  auto points() const { return AliveRange(points_); }
  auto handles() const { return AliveRange(handles_); }
  auto faces() const { return AliveRange(faces_); }
  auto halfedges() const { return AliveRange(halfedges_); }

  /// Return the sizes of the arrays, counting elements that are not alive: bounds for arrays beside
  /// the mesh.
  std::size_t face_slots() const { return faces_.size(); }
  std::size_t halfedge_slots() const { return halfedges_.size(); }

  int face_count() const { return face_count_; }

  /// Returns true if nothing of the face's patch may change.
  bool is_fixed(Face f) const { return (*this)[f].fixed; }
  bool has_fixed_faces() const { return fixed_face_count() > 0; }
  int fixed_face_count() const;

  /// Compares record by record, those that are not alive too: an undo restores all of them.
  bool operator==(const Mesh&) const = default;

  // --- the half-edge tree ---
  bool is_parent(Halfedge h) const { return (*this)[h].first_child.valid(); }
  bool is_leaf(Halfedge h) const { return !is_parent(h); }
  bool is_child(Halfedge h) const { return (*this)[h].parent.valid(); }
  bool is_bar(Halfedge h) const {
    return is_child(h) && (*this)[h].interval.first < (*this)[h].interval.second;
  }
  bool is_stem(Halfedge h) const { return is_child(h) && !is_bar(h); }

  /// Returns the half-edge that is one whole side of the curve on which h lies: h, or the parent of
  /// h where h is a bar.
  Halfedge curve_side(Halfedge h) const { return is_bar(h) ? (*this)[h].parent : h; }
  /// Returns the part of its curve side that h spans.
  Interval span(Halfedge h) const { return is_bar(h) ? (*this)[h].interval : Interval{}; }
  /// Returns the other side of h's curve; invalid on the boundary.
  Halfedge other_side(Halfedge h) const { return (*this)[curve_side(h)].twin; }
  /// Returns the half-edge that names the whole curve of h: of its sides the one of smaller index.
  Halfedge curve(Halfedge h) const {
    const Halfedge side = curve_side(h), twin = (*this)[side].twin;
    return twin.valid() && twin < side ? twin : side;
  }
  /// Returns all curves, as curve() names them, in the order of their indices.
  std::vector<Halfedge> curves() const;

  /// Returns the bars and stems in turn, in the parent's direction.
  SiblingRange children(Halfedge parent) const { return range(parent, SiblingRange::children); }
  /// Returns the leaves along a curve side, in its direction: its bars, or the side itself.
  SiblingRange leaves(Halfedge side) const {
    return is_leaf(side) ? SiblingRange(halfedges_, side, SiblingRange::alone)
                         : range(side, SiblingRange::bars);
  }
  SiblingRange stems(Halfedge side) const { return range(side, SiblingRange::stems); }
  Halfedge first_leaf(Halfedge side) const {
    return is_leaf(side) ? side : (*this)[side].first_child;
  }
  Halfedge last_leaf(Halfedge side) const;

  // --- faces ---
  Halfedge next(Halfedge leaf) const { return (*this)[leaf].next; }
  Halfedge prev(Halfedge leaf) const { return (*this)[leaf].prev; }
  Face face(Halfedge leaf) const { return (*this)[leaf].face; }
  /// Returns the four sides of a face, clockwise from its top.
  std::array<Halfedge, 4> sides(Face f) const { return sides((*this)[f].halfedge); }
  /// Returns the four sides of a leaf's face, clockwise from the leaf.
  std::array<Halfedge, 4> sides(Halfedge leaf) const;
  /// Returns which of sides(face(leaf)) the leaf is.
  int side_number(Halfedge leaf) const;

  // --- geometry ---
  Point origin(Halfedge h) const { return (*this)[h].origin; }
  Point end(Halfedge h) const;
  glm::dvec2 position(Point p) const { return (*this)[p].position; }

  /// Returns the curve of a whole curve side in the side's own direction, with the colours of that
  /// side's faces (linear between its ends in the model `bilinear`).
  Cubic<Value> curve_of(Halfedge side) const;
  /// Returns the curve of a leaf, which is a part of its curve side. The ends are exactly the
  /// positions of the leaf's points.
  Cubic<Value> side_of(Halfedge leaf) const;
  Patch patch(Face f) const { return patch((*this)[f].halfedge); }
  /// Returns the patch as seen with this side as its top, wherever its face begins.
  Patch patch(Halfedge top) const;

 private:
  friend class Journal;
  friend class MeshBuilder;
  friend class MeshDifference;

  SiblingRange range(Halfedge parent, SiblingRange::Kind kind) const {
    return {halfedges_, (*this)[parent].first_child, kind};
  }

  std::vector<PointRecord> points_;
  std::vector<HandleRecord> handles_;
  std::vector<FaceRecord> faces_;
  std::vector<HalfedgeRecord> halfedges_;
  int face_count_ = 0;
  ColorModel color_model_ = ColorModel::bilinear;
  bool smooth_ = false;
};

/// Returns true if a mesh is not opaque everywhere: if some corner's opacity, rounded to 8 bits, is
/// not 255.
bool is_translucent(const Mesh& mesh);

}  // namespace gradmesh
