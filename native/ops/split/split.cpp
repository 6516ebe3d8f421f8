#include "ops/split/split.h"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>

#include "mesh/dependence.h"
#include "ops/refresh.h"

namespace gradmesh {
namespace {

class Split {
 public:
  Split(Journal& journal, Halfedge side, double t)
      : journal_(journal), mesh_(journal.mesh()), side_(side), t_(t) {}

  Halfedge run() {
    const std::array<Patch, 2> parts = mesh_.patch(side_).split_v(t_);
    const std::array<Halfedge, 4> sides = mesh_.sides(side_);
    const auto [top, right, bottom, left] = sides;
    const Face first = mesh_.face(side_);
    const auto first_side = std::ranges::find(sides, mesh_[first].halfedge) - sides.begin();

    const Cut top_cut = cut(top, t_), bottom_cut = cut(bottom, 1 - t_);
    const Halfedge edge = journal_.add(HalfedgeRecord{}), twin = journal_.add(HalfedgeRecord{});
    add_curve(edge, twin, parts[0].side(1));
    start_at(edge, top_cut);
    start_at(twin, bottom_cut);

    const Face second = journal_.add_face(FaceRecord{});
    const std::array<Halfedge, 4> first_loop{top_cut.first, edge, bottom_cut.second, left};
    const std::array<Halfedge, 4> second_loop{top_cut.second, right, bottom_cut.first, twin};
    close_loop(first, first_loop, parts[0]);
    close_loop(second, second_loop, parts[1]);
    keep_colors(edge, top_cut, parts[0].side(0), parts[1].side(0));
    keep_colors(twin, bottom_cut, parts[1].side(2), parts[0].side(2));
    // u and v keep their directions in both parts.
    journal_.edit(first).halfedge = first_loop[first_side];
    journal_.edit(second).halfedge = second_loop[first_side];
    journal_.touch(first);
    journal_.touch(second);
    refresh(journal_, std::array{mesh_.curve(top), mesh_.curve(bottom), mesh_.curve(edge)});
    return edge;
  }

 private:
  /// The two parts of a leaf that is cut, and the point between them.
  struct Cut {
    Halfedge first, second;
    Point point;
    /// The parent on which the point is a T-junction at t; invalid on the boundary.
    Halfedge parent;
    double t;
  };

  HalfedgeRecord& edit(Halfedge h) { return journal_.edit(h); }

  Cut cut(Halfedge leaf, double t) {
    const Point point = journal_.add(PointRecord{mesh_.side_of(leaf).at(t).position, {}, {}});
    if (!mesh_.is_bar(leaf) && !mesh_[leaf].twin.valid()) return cut_boundary(leaf, t, point);

    if (mesh_.is_bar(leaf)) return cut_bar(leaf, t, point);
    const Halfedge bar = journal_.add(HalfedgeRecord{});
    HalfedgeRecord& record = edit(bar);
    const HalfedgeRecord& parent = mesh_[leaf];
    record.origin = parent.origin;
    record.color = parent.color;
    record.own_color = parent.own_color;
    record.parent = leaf;
    edit(leaf).first_child = bar;
    edit(leaf).next = edit(leaf).prev = {};
    edit(leaf).face = {};
    return cut_bar(bar, t, point);
  }

  Cut cut_bar(Halfedge bar, double t, Point point) {
    const Halfedge second = journal_.add(HalfedgeRecord{});
    HalfedgeRecord& before = edit(bar);
    HalfedgeRecord& after = edit(second);
    const double at = before.interval.first + t * before.interval.length();
    after.origin = point;
    after.parent = before.parent;
    after.interval = {at, before.interval.second};
    after.next_sibling = before.next_sibling;
    before.interval.second = at;
    before.next_sibling = second;
    return {bar, second, point, before.parent, at};
  }

  Cut cut_boundary(Halfedge leaf, double t, Point point) {
    const Cubic<Value> curve = mesh_.side_of(leaf);
    const Cubic<Value> first = curve.part(0, t), second = curve.part(t, 1);
    const Halfedge after = journal_.add(HalfedgeRecord{});
    const std::array<Handle, 2> ends = mesh_[leaf].handles;
    journal_.edit(ends[0]).tangent = first.m0;
    journal_.edit(ends[1]).tangent = -second.m1;
    const Handle back = journal_.add(HandleRecord{-first.m1, {}});
    const Handle forth = journal_.add(HandleRecord{second.m0, after});
    edit(leaf).handles = {ends[0], back};
    edit(after).handles = {forth, ends[1]};
    edit(after).origin = point;
    journal_.edit(point).halfedge = after;
    return {leaf, after, point, {}, 0};
  }

  void add_curve(Halfedge edge, Halfedge twin, const Cubic<Value>& curve) {
    const Handle start = journal_.add(HandleRecord{curve.m0, edge});
    const Handle end = journal_.add(HandleRecord{-curve.m1, twin});
    edit(edge).twin = twin;
    edit(twin).twin = edge;
    edit(edge).handles = {start, end};
    edit(twin).handles = {end, start};
  }

  /// Makes a half-edge of the new curve start at the point of `cut`, as a stem unless on the
  /// boundary.
  void start_at(Halfedge h, const Cut& cut) {
    edit(h).origin = cut.point;
    if (!cut.parent.valid()) return;
    edit(h).parent = cut.parent;
    edit(h).interval = {cut.t, cut.t};
    edit(h).next_sibling = cut.second;
    edit(cut.first).next_sibling = h;
    journal_.edit(cut.point).stem = journal_.edit(cut.point).halfedge = h;
  }

  void close_loop(Face face, const std::array<Halfedge, 4>& loop, const Patch& patch) {
    for (int k = 0; k < 4; ++k) {
      HalfedgeRecord& record = edit(loop[k]);
      record.face = face;
      record.next = loop[(k + 1) % 4];
      record.prev = loop[(k + 3) % 4];
      record.twist = patch.twist(k);
      record.color = patch.corner(k).color;
    }
  }

  /// Lets the bars at a new T-junction, whose curves are `first` and `second`, and the stem keep
  /// their colours where these are not the colours of the parent's curve, since a bar has a colour
  /// of its own at one of its other ends.
  void keep_colors(Halfedge stem, const Cut& cut, const Cubic<Value>& first,
                   const Cubic<Value>& second) {
    if (!cut.parent.valid()) return;
    const bool own = !is_rounding(second.p0.color - junction_value(mesh_, stem).color);
    edit(stem).own_color = edit(cut.second).own_color = own;
    if (mesh_.color_model() == ColorModel::bilinear) return;
    keep_tangents(cut.first, first);
    keep_tangents(cut.second, second);
  }

  void keep_tangents(Halfedge bar, const Cubic<Value>& curve) {
    edit(bar).own_tangents = {};
    const Cubic<Value> of_parent = mesh_.side_of(bar);
    const std::array<glm::dvec4, 2> own{curve.m0.color - of_parent.m0.color,
                                        curve.m1.color - of_parent.m1.color};
    if (!is_rounding(own[0]) || !is_rounding(own[1])) edit(bar).own_tangents = own;
  }

  static bool is_rounding(const glm::dvec4& difference) {
    constexpr double rounding = 1e-13;
    return glm::length(difference) <= rounding;
  }

  Journal& journal_;
  const Mesh& mesh_;
  const Halfedge side_;
  const double t_;
};

}  // namespace

Halfedge split(Journal& journal, Halfedge side, double t) {
  assert(journal.mesh().is_leaf(side) && t > 0 && t < 1);
  journal.begin();
  return Split(journal, side, t).run();
}

}  // namespace gradmesh
