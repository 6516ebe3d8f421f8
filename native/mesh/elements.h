#pragma once

#include <array>
#include <compare>

#include "base/value.h"

namespace gradmesh {

/// Index of one element; a distinct type per element so that they cannot be mixed up.
template <class Record>
struct Index {
  int value = -1;

  bool valid() const { return value >= 0; }
  auto operator<=>(const Index&) const = default;
};

struct PointRecord;
struct HandleRecord;
struct FaceRecord;
struct HalfedgeRecord;
using Point = Index<PointRecord>;
using Handle = Index<HandleRecord>;
using Face = Index<FaceRecord>;
using Halfedge = Index<HalfedgeRecord>;

/// A control point or a T-junction. At a T-junction, `stem` is the half-edge that starts there as a
/// stem, and the position is kept equal to the point of the stem's parent.
struct PointRecord {
  glm::dvec2 position{0.0};
  /// A half-edge that starts here and is no bar.
  Halfedge halfedge;
  Halfedge stem;
  bool alive = true;

  bool is_junction() const { return stem.valid(); }
  bool operator==(const PointRecord&) const = default;
};

/// Tangent of a curve at one of its ends, pointing from the end into the curve. The colour part
/// counts in the colour model `bicubic` only.
struct HandleRecord {
  Value tangent;
  /// The half-edge that starts where the handle is.
  Halfedge halfedge;
  bool alive = true;

  bool operator==(const HandleRecord&) const = default;
};

struct FaceRecord {
  /// The top side of the patch (u = 0).
  Halfedge halfedge;
  bool alive = true;
  /// True if nothing of the patch may change, nor any point on its border.
  bool fixed = false;

  bool operator==(const FaceRecord&) const = default;
};

/// Two faces of which one lies over the other, with none between them, at some pixel.
struct Overlap {
  Face below, above;

  auto operator<=>(const Overlap&) const = default;
};

/// Which part of its parent a child spans, in the parent's direction. A stem spans one point.
struct Interval {
  double first = 0, second = 1;

  double length() const { return second - first; }
  bool operator==(const Interval&) const = default;
};

/// A curve is a pair of twins, or one half-edge on the boundary. Where the faces on one side of
/// a curve are several, the half-edge of that side is a parent without a face, and its children
/// are in turn the bars, one a face, and the stems that start between them (paper, 2.2, Fig. 2).
/// A stem is a curve of its own and may be a parent again, to any depth.
///
///                 leaf (has a face)            parent (has children)
///   curve side    twin, handles                twin, handles, first_child
///   bar           parent, interval             (a bar of a bar is kept as a bar of the parent)
struct HalfedgeRecord {
  Point origin;
  /// The half-edge on the other side of the curve; none for bars and on the boundary.
  Halfedge twin;
  /// Tangents at the start and at the end; none for bars, which take the parent's.
  std::array<Handle, 2> handles;

  /// Children only.
  Halfedge parent;
  Interval interval;
  Halfedge next_sibling;
  /// Parents only.
  Halfedge first_child;

  /// Leaves only: the loop of the face. Twist and colour are those of the face's corner at the
  /// origin.
  Halfedge next, prev;
  Face face;
  /// Mixed derivative in the local axes of Patch::twist. Its colour part counts in `bicubic` only.
  Value twist;
  glm::dvec4 color{0.0};
  /// At a T-junction: false where the colour is kept equal to that of the parent's curve.
  bool own_color = true;
  /// Bars only, in `bicubic`: the difference of the colour tangents at the start and at the end
  /// from those of the parent's curve. It is not zero where a side between T-junctions with colours
  /// of their own was split.
  std::array<glm::dvec4, 2> own_tangents{glm::dvec4(0.0), glm::dvec4(0.0)};

  bool alive = true;

  bool operator==(const HalfedgeRecord&) const = default;
};

}  // namespace gradmesh
