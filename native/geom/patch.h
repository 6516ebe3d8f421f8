#pragma once

#include <array>

#include "base/affine.h"
#include "base/value.h"
#include "geom/cubic.h"

namespace gradmesh {

/// Corners and sides are counted clockwise as in SVG: corner k is the start of side k;
/// side 0 is the top (u = 0, v grows), 1 the right, 2 the bottom (v falls), 3 the left.
/// u runs from top to bottom, v from left to right (Eq. 1 and 3).
struct Patch {
  /// Hermite control matrix C of Eq. 3:
  ///   m0   m0_v   m2_v   m2
  ///   m0_u m0_uv  m2_uv  m2_u
  ///   m1_u m1_uv  m3_uv  m3_u
  ///   m1   m1_v   m3_v   m3
  /// (the paper's copy has m0_u where the first row needs m0_v).
  std::array<std::array<Value, 4>, 4> c{};

  bool operator==(const Patch&) const = default;

  /// Returns H(u, v) of Eq. 1.
  Value at(double u, double v) const;
  Value derivative_u(double u, double v) const;
  Value derivative_v(double u, double v) const;

  Value corner(int k) const;
  /// Returns the curve of side k in the side's own direction.
  Cubic<Value> side(int k) const;
  /// Returns the mixed derivative at corner k along (side k, the reverse of side k-1). In these
  /// local axes its value does not depend on which side of a face is called the top.
  Value twist(int k) const;

  /// Return the part [a, b] of u or of v, exactly (A.1).
  Patch part_u(double a, double b) const;
  Patch part_v(double a, double b) const;
  /// Return the parts [0, t] and [t, 1] of u or of v. t in (0, 1).
  std::array<Patch, 2> split_u(double t) const;
  std::array<Patch, 2> split_v(double t) const;
};

/// Returns the patch with these four sides (clockwise, each starting where the one before ends) and
/// these four twists, in local axes as of Patch::twist.
Patch patch_from_sides(const std::array<Cubic<Value>, 4>& sides,
                       const std::array<Value, 4>& twists);

/// Bezier control points, b[i][j] with i along u, j along v.
using BezierNet = std::array<std::array<Value, 4>, 4>;
BezierNet bezier_net(const Patch& patch);
Patch patch_from_bezier(const BezierNet& net);

/// Returns the positions of the interior control points b11, b12, b21, b22 of the Coons patch with
/// the net's boundary (SVG 2 without `tensor`; formula in PDF 32000-1, 8.7.4.5.8).
std::array<std::array<glm::dvec2, 2>, 2> coons_interior(const BezierNet& net);

/// Gives the patch the interior control points of the Coons patch with its sides.
void make_coons(Patch& patch);

/// Applies an affine map to the patch's positions.
void transform(Patch& patch, const Affine& affine);

/// Replaces every colour tangent and twist by those of the bilinear blend of the four corner
/// colours: all the colour that an SVG patch can hold.
void make_color_bilinear(Patch& patch);

}  // namespace gradmesh
