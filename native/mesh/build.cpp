#include "mesh/build.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/limits.h"
#include "mesh/dependence.h"

namespace gradmesh {
namespace {

[[noreturn]] void inconsistent(const Message& what) {
  throw InputError("the patches of the mesh do not fit together: {0}.", what);
}

}  // namespace

class MeshBuilder {
 public:
  explicit MeshBuilder(const MeshParts& parts) : parts_(parts), own_colors_(parts.own_colors) {
    mesh_.color_model_ = parts.color_model;
    mesh_.smooth_ = parts.smooth;
    std::ranges::sort(own_colors_);
  }

  Mesh build() {
    add_faces();
    for (const CurveParts& curve : parts_.curves) add_curve(curve);
    add_boundary();
    join_corners();
    add_points();
    for (const Halfedge parent : parents_) add_stems(parent);
    place_junctions();
    return std::move(mesh_);
  }

 private:
  HalfedgeRecord& at(Halfedge h) { return mesh_.halfedges_[h.value]; }

  void add_faces() {
    const int count = int(parts_.patches.size());
    mesh_.face_count_ = count;
    mesh_.halfedges_.resize(4 * parts_.patches.size());
    for (int f = 0; f < count; ++f) {
      mesh_.faces_.push_back({Halfedge{4 * f}});
      for (int k = 0; k < 4; ++k) {
        HalfedgeRecord& h = at(Halfedge{4 * f + k});
        h.face = Face{f};
        h.next = Halfedge{4 * f + (k + 1) % 4};
        h.prev = Halfedge{4 * f + (k + 3) % 4};
        h.twist = parts_.patches[f].twist(k);
        h.color = parts_.patches[f].corner(k).color;
      }
    }
    for (const int f : parts_.fixed) mesh_.faces_[std::size_t(f)].fixed = true;
    used_.assign(mesh_.halfedges_.size(), false);
  }

  void add_curve(const CurveParts& curve) {
    const Halfedge a = add_side(curve.a), b = add_side(curve.b);
    at(a).twin = b;
    at(b).twin = a;
    const bool use_a = mesh_.is_leaf(a) || !mesh_.is_leaf(b);
    if (curve.tangents)
      add_handles(a, *curve.tangents);
    else
      add_handles(use_a ? a : b);
  }

  /// Adds a side and returns its half-edge: the only leaf, or a new parent above the bars.
  Halfedge add_side(const CurveSide& side) {
    if (side.halfedges.empty() || side.breaks.size() + 1 != side.halfedges.size())
      inconsistent(Message("a curve has no side, or not one break fewer than patches"));
    for (const int h : side.halfedges) {
      if (h < 0 || h >= int(used_.size()))
        inconsistent(Message("a curve names a patch that is not there"));
      if (used_[h]) inconsistent(Message("a side of a patch lies on two curves"));
      used_[h] = true;
    }
    if (side.halfedges.size() == 1) return Halfedge{side.halfedges[0]};

    const Halfedge parent{int(mesh_.halfedges_.size())};
    mesh_.halfedges_.emplace_back();
    parents_.push_back(parent);
    double from = 0;
    for (std::size_t i = 0; i < side.halfedges.size(); ++i) {
      const double to = i < side.breaks.size() ? side.breaks[i] : 1.0;
      if (!(from < to && to <= 1))
        inconsistent(Message("the breaks of a curve do not rise from 0 to 1"));
      const Halfedge bar{side.halfedges[i]};
      at(bar).parent = parent;
      at(bar).interval = {from, to};
      if (i == 0)
        at(parent).first_child = bar;
      else
        at(Halfedge{side.halfedges[i - 1]}).next_sibling = bar;
      from = to;
    }
    return parent;
  }

  /// Adds handles for the tangents of the patches along a side.
  void add_handles(Halfedge side) {
    const Halfedge first = mesh_.first_leaf(side), last = mesh_.last_leaf(side);
    const Value start = patch_side(first).m0 * (1 / mesh_.span(first).length());
    const Value end = -patch_side(last).m1 * (1 / mesh_.span(last).length());
    add_handles(side, {start, end});
  }
  void add_handles(Halfedge side, const std::array<Value, 2>& tangents) {
    const Handle h0{int(mesh_.handles_.size())}, h1{h0.value + 1};
    mesh_.handles_.push_back({tangents[0], side});
    mesh_.handles_.push_back({tangents[1], at(side).twin});
    at(side).handles = {h0, h1};
    if (at(side).twin.valid()) at(at(side).twin).handles = {h1, h0};
  }

  Cubic<Value> patch_side(Halfedge leaf) const {
    return parts_.patches[leaf.value / 4].side(leaf.value % 4);
  }

  void add_boundary() {
    for (int h = 0; h < int(used_.size()); ++h)
      if (!used_[h]) add_handles(Halfedge{h});
  }

  // --- points: the corners (each named by the leaf that starts there) that meet ---

  int find(int corner) {
    while (group_[corner] != corner) corner = group_[corner] = group_[group_[corner]];
    return corner;
  }
  void join(Halfedge a, Halfedge b) {
    const int x = find(a.value), y = find(b.value);
    group_[std::max(x, y)] = std::min(x, y);
  }

  void join_corners() {
    group_.resize(used_.size());
    std::iota(group_.begin(), group_.end(), 0);
    for (int i = 0; i < int(mesh_.halfedges_.size()); ++i) {
      const Halfedge side{i};
      if (mesh_.is_bar(side)) continue;
      const Halfedge twin = at(side).twin;
      if (twin.valid()) join(mesh_.first_leaf(side), mesh_.next(mesh_.last_leaf(twin)));
      const std::vector<Halfedge> bars = mesh_.leaves(side).list();
      for (std::size_t k = 1; k < bars.size(); ++k) join(mesh_.next(bars[k - 1]), bars[k]);
    }
  }

  void add_points() {
    std::vector<Point> point_of(group_.size());
    for (int h = 0; h < int(group_.size()); ++h) {
      Point& p = point_of[find(h)];
      if (!p.valid()) {
        p = Point{int(mesh_.points_.size())};
        mesh_.points_.push_back({parts_.patches[h / 4].corner(h % 4).position, Halfedge{}, {}});
      }
      at(Halfedge{h}).origin = p;
    }
    for (const Halfedge parent : parents_) at(parent).origin = at(mesh_.first_leaf(parent)).origin;
    for (int i = 0; i < int(mesh_.halfedges_.size()); ++i) {
      const Halfedge h{i};
      PointRecord& p = mesh_.points_[at(h).origin.value];
      if (!mesh_.is_bar(h) && !p.halfedge.valid()) p.halfedge = h;
    }
  }

  /// Makes the curve between any two neighbouring bars of `parent` a stem of `parent`.
  void add_stems(Halfedge parent) {
    const std::vector<Halfedge> bars = mesh_.leaves(parent).list();
    for (std::size_t k = 1; k < bars.size(); ++k) {
      const Halfedge before = bars[k - 1], after = bars[k];
      const Halfedge stem = mesh_.curve_side(mesh_.next(before));
      const Halfedge back = mesh_.curve_side(mesh_.prev(after));
      if (at(stem).twin != back || mesh_.origin(stem) != mesh_.origin(after))
        inconsistent(Message("between two patches beside a longer one there must be one curve"));
      PointRecord& junction = mesh_.points_[mesh_.origin(after).value];
      if (junction.is_junction()) inconsistent(Message("a point lies inside two curves"));
      junction.stem = junction.halfedge = stem;
      at(stem).parent = parent;
      const double t = at(before).interval.second;
      at(stem).interval = {t, t};
      at(before).next_sibling = stem;
      at(stem).next_sibling = after;
    }
  }

  /// Puts the T-junctions of each curve on it once the curve's ends are placed.
  void place_junctions() {
    if (has_cycle(mesh_)) inconsistent(Message("a curve hangs on itself"));
    for (const Halfedge curve : in_order_of_dependence(mesh_, mesh_.curves()))
      for (const Halfedge side : {curve, at(curve).twin})
        if (side.valid())
          for (const Halfedge stem : mesh_.stems(side)) place_junction(stem);
  }

  void place_junction(Halfedge stem) {
    const Value value = junction_value(mesh_, stem);
    mesh_.points_[mesh_.origin(stem).value].position = value.position;
    // The rounding of a writer: half a level of 8 bits and a little, or of six digits.
    const double tolerance = mesh_.color_model_ == ColorModel::bilinear ? 0.51 / 255 : 1e-5;
    for (const Halfedge leaf : {mesh_.first_leaf(stem), at(stem).next_sibling}) {
      const glm::dvec4 difference = at(leaf).color - value.color;
      at(leaf).own_color = std::ranges::binary_search(own_colors_, leaf.value);
      for (int i = 0; i < 4; ++i)
        if (std::abs(difference[i]) > tolerance) at(leaf).own_color = true;
      if (!at(leaf).own_color) at(leaf).color = value.color;
    }
  }

  const MeshParts& parts_;
  std::vector<int> own_colors_;
  Mesh mesh_;
  std::vector<bool> used_;
  std::vector<int> group_;
  std::vector<Halfedge> parents_;
};

Mesh build_mesh(const MeshParts& parts) {
  const std::size_t patches = parts.patches.size(), most = limits().patches;
  if (patches > most)
    throw InputError("it has {0} patches, {1}.", patches, beyond_limit("patches", most, patches));
  return build_derived_mesh(parts);
}

Mesh build_derived_mesh(const MeshParts& parts) { return MeshBuilder(parts).build(); }

}  // namespace gradmesh
