#include "mesh/subdivide.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

namespace gradmesh {
namespace {

/// Colours that differ by less are equal up to rounding.
constexpr double same_color = 1e-9;

class Subdivider {
 public:
  Subdivider(const Mesh& mesh, int n) : mesh_(mesh), n_(n), number_(mesh.halfedge_slots(), -1) {
    parts_.color_model = mesh.color_model();
  }

  MeshParts run() {
    for (const Face f : mesh_.faces()) add_face(f);
    for (const Halfedge curve : mesh_.curves())
      if (mesh_[curve].twin.valid()) add_curve(curve);
    return std::move(parts_);
  }

 private:
  /// A side of a new patch along an old curve side, and the part of the curve side that it spans.
  struct Piece {
    int halfedge;
    double first, second;
    /// True if the corner of the patch at that end is a T-junction with its own colour.
    bool own_at_start = false, own_at_end = false;
  };
  using Pieces = std::span<const Piece>;

  void add_face(Face f) {
    const int first = int(parts_.patches.size());
    const std::array<Halfedge, 4> sides = mesh_.sides(f);
    for (int k = 0; k < 4; ++k) number_[std::size_t(sides[k].value)] = 4 * first + k;
    const Patch patch = mesh_.patch(f);
    MeshParts parts{{}, grid_curves(n_, n_)};
    for (int i = 0; i < n_; ++i) {
      const Patch row = patch.part_u(double(i) / n_, double(i + 1) / n_);
      for (int j = 0; j < n_; ++j)
        parts.patches.push_back(row.part_v(double(j) / n_, double(j + 1) / n_));
    }
    if (mesh_.is_fixed(f))
      for (int i = 0; i < n_ * n_; ++i) parts.fixed.push_back(i);
    append(parts_, parts);
  }

  /// Returns the side of the m-th new patch along a leaf, as 4 * patch + side.
  int side_along(Halfedge leaf, int m) const {
    const int number = number_[std::size_t(leaf.value)], k = number % 4;
    const int back = n_ - 1 - m, last = n_ - 1;
    const int row = std::array{0, m, last, back}[std::size_t(k)];
    const int column = std::array{m, last, back, 0}[std::size_t(k)];
    return number + 4 * (row * n_ + column);
  }

  bool own_color(Halfedge leaf) const {
    return mesh_[mesh_.origin(leaf)].is_junction() && mesh_[leaf].own_color;
  }

  std::vector<Piece> pieces(Halfedge side) const {
    std::vector<Piece> result;
    for (const Halfedge leaf : mesh_.leaves(side)) {
      const Interval span = mesh_.span(leaf);
      const auto at = [&](int m) { return std::lerp(span.first, span.second, double(m) / n_); };
      for (int m = 0; m < n_; ++m) result.push_back({side_along(leaf, m), at(m), at(m + 1)});
      result[result.size() - std::size_t(n_)].own_at_start = own_color(leaf);
      result.back().own_at_end = own_color(mesh_.next(leaf));
    }
    return result;
  }

  /// Cuts the curve wherever both of its sides are divided.
  void add_curve(Halfedge side) {
    const std::vector<Piece> a = pieces(side), b = pieces(mesh_[side].twin);
    std::size_t i = 0, j = 0;  // pieces done, those of b from its end
    while (i < a.size()) {
      const std::size_t first_a = i++, first_b = j++;
      const auto gap = [&] { return a[i - 1].second - (1 - b[b.size() - j].first); };
      while (std::abs(gap()) > same_place && i < a.size() && j < b.size()) ++(gap() < 0 ? i : j);
      // A remainder of only one side is no curve of its own.
      if (i == a.size()) j = b.size();
      if (j == b.size()) i = a.size();
      add_part(side, Pieces(a).subspan(first_a, i - first_a),
               Pieces(b).subspan(b.size() - j, j - first_b));
    }
  }

  /// Adds the part of an old curve along which the pieces lie.
  void add_part(Halfedge side, Pieces a, Pieces b) {
    const Cubic<Value> curve = mesh_.curve_of(side).part(a.front().first, a.back().second);
    parts_.curves.push_back({curve_side(a), curve_side(b), std::array{curve.m0, -curve.m1}});
    add_own_colors(curve, a);
    add_own_colors(curve.reversed(), b);
  }

  /// Returns the end of a piece as a parameter of the part from the first to the last of `pieces`.
  static double break_after(const Piece& piece, Pieces pieces) {
    const double first = pieces.front().first;
    return (piece.second - first) / (pieces.back().second - first);
  }

  static CurveSide curve_side(Pieces pieces) {
    CurveSide result;
    for (const Piece& piece : pieces) {
      result.halfedges.push_back(piece.halfedge);
      result.breaks.push_back(break_after(piece, pieces));
    }
    result.breaks.pop_back();
    return result;
  }

  glm::dvec4 color_at_start(int halfedge) const {
    return parts_.patches[std::size_t(halfedge / 4)].corner(halfedge % 4).color;
  }
  static int next(int halfedge) { return halfedge - halfedge % 4 + (halfedge + 1) % 4; }

  /// Adds the corners at T-junctions whose colours are not those of the new curve, which starts and
  /// ends in the colours of its own patches.
  void add_own_colors(Cubic<Value> curve, Pieces pieces) {
    curve.p0.color = color_at_start(pieces.front().halfedge);
    curve.p1.color = color_at_start(next(pieces.back().halfedge));
    if (mesh_.color_model() == ColorModel::bilinear)
      curve.m0.color = curve.m1.color = curve.p1.color - curve.p0.color;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      const Piece &before = pieces[i - 1], &after = pieces[i];
      const glm::dvec4 color = curve.at(break_after(before, pieces)).color;
      const auto add = [&](int halfedge, bool own) {
        if (own || glm::length(color_at_start(halfedge) - color) > same_color)
          parts_.own_colors.push_back(halfedge);
      };
      add(next(before.halfedge), before.own_at_end);
      add(after.halfedge, after.own_at_start);
    }
  }

  const Mesh& mesh_;
  const int n_;
  MeshParts parts_;
  /// For each leaf, its number 4 * patch + side, with the first new patch of its face.
  std::vector<int> number_;
};

}  // namespace

MeshParts subdivided(const Mesh& mesh, int n) { return Subdivider(mesh, n).run(); }

}  // namespace gradmesh
