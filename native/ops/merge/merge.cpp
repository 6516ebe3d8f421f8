#include "ops/merge/merge.h"

#include <cassert>

#include "ops/merge/merge_end.h"
#include "ops/merge/split_share.h"
#include "ops/refresh.h"

namespace gradmesh {
namespace {

class Merge {
 public:
  Merge(Journal& journal, Halfedge edge)
      : journal_(journal), mesh_(journal.mesh()), edge_(edge), twin_(mesh_[edge].twin) {}

  void run() {
    const MergeEnd tail = merge_end(mesh_, edge_), head = merge_end(mesh_, twin_);
    const double r = split_factor(mesh_, edge_, tail, head);
    const double r_tail = split_share(mesh_, tail, r);
    const double r_head = split_share(mesh_, head, 1 - r);
    const Face kept = mesh_.face(edge_), gone = mesh_.face(twin_);
    const Halfedge opposite = mesh_.next(head.out), twin_opposite = mesh_.next(tail.out);
    // u and v keep their directions: the top stays or, where the edge itself was the top, it is
    // now the side opposite in the other face.
    const Halfedge top = mesh_[kept].halfedge;

    scale_twists(tail, r_tail);
    scale_twists(head, r_head);
    const Halfedge tail_side = join(tail, r_tail), head_side = join(head, r_head);
    close_loop(kept, {tail_side, twin_opposite, head_side, opposite});
    journal_.edit(kept).halfedge = top == edge_      ? twin_opposite
                                   : top == tail.in  ? tail_side
                                   : top == head.out ? head_side
                                                     : opposite;
    remove_curve(edge_);
    journal_.remove_face(gone);
    journal_.touch(kept);
    refresh(journal_, std::array{mesh_.curve(tail_side), mesh_.curve(head_side)});
  }

 private:
  HalfedgeRecord& edit(Halfedge h) { return journal_.edit(h); }

  /// Applies the second and third columns of Eq. 5: scales the twists at the far corners of one of
  /// the two sides.
  void scale_twists(const MergeEnd& end, double r) {
    const Halfedge far_in = end.in, far_out = mesh_.next(end.out);
    edit(far_in).twist *= 1 / r;
    edit(far_out).twist *= 1 / (1 - r);
  }

  Halfedge join(const MergeEnd& end, double r) {
    switch (end.kind) {
      case MergeEnd::stem:
        return join_bars(end);
      case MergeEnd::boundary:
        return join_boundary(end, r);
      default:
        return join_curves(end, r);
    }
  }

  /// Removes a T-junction (Fig. 4b). The parent's curve stays as it is.
  Halfedge join_bars(const MergeEnd& end) {
    const Halfedge parent = mesh_[end.in].parent;
    const Halfedge after = mesh_[end.out].next_sibling;
    journal_.remove(mesh_.origin(end.out));
    if (mesh_[parent].first_child == end.in && !after.valid()) {
      take_corner(parent, end.in);
      edit(parent).first_child = {};
      journal_.remove(end.in);
      journal_.remove(end.out);
      return parent;
    }
    const double in = mesh_[end.in].interval.length(), out = mesh_[end.out].interval.length();
    join_own_tangents(end.in, end.out, in / (in + out));
    edit(end.in).interval.second = mesh_[end.out].interval.second;
    edit(end.in).next_sibling = after;
    journal_.remove(end.out);
    return end.in;
  }

  Halfedge join_boundary(const MergeEnd& end, double r) {
    journal_.remove(mesh_.origin(end.out));
    join_handles(end.in, end.out, r);
    journal_.remove(end.out);
    return end.in;
  }

  /// Combines the two curves and inserts a T-junction (Fig. 4a, c). Each side of the combined
  /// curve keeps the half-edge that starts where it starts.
  Halfedge join_curves(const MergeEnd& end, double r) {
    const Halfedge in = mesh_.curve_side(end.in), out = mesh_.curve_side(end.out);
    const Halfedge in_twin = mesh_[in].twin, out_twin = mesh_[out].twin;
    const double t = combined_share(mesh_, end, r);

    join_handles(in, out, t);
    edit(in).twin = out_twin;
    edit(out_twin).twin = in;

    const Children before = children_over(out_twin, {0, 1 - t}, out_twin);
    const Children after = children_over(in_twin, {1 - t, 1}, out_twin);
    edit(out_twin).first_child = before.first;
    edit(before.last).next_sibling = end.across;
    hang_stem(end.across, out_twin, 1 - t, after.first);
    const Halfedge side = near_side(end, in, out, t);
    if (in_twin != after.first) journal_.remove(in_twin);
    return side;
  }

  /// Joins the side of the merged face, and its children where it is divided. Returns the face's
  /// leaf.
  Halfedge near_side(const MergeEnd& end, Halfedge in, Halfedge out, double t) {
    if (end.in == in && end.out == out) {
      journal_.remove(out);
      return in;
    }
    const double first = end.in == in ? 0.0 : t * mesh_[end.in].interval.first;
    const double second = end.out == out ? 1.0 : t + (1 - t) * mesh_[end.out].interval.second;
    const Children before = children_over(in, {0, t}, in), after = children_over(out, {t, 1}, in);
    const Halfedge bar = before.last;
    join_own_tangents(bar, after.first, (t - first) / (second - first));
    edit(bar).interval = {first, second};
    edit(bar).next_sibling = mesh_[after.first].next_sibling;
    edit(in).first_child = before.first;
    journal_.remove(end.out);
    if (out != end.out) journal_.remove(out);
    return bar;
  }

  /// Consecutive children of one parent, each linked to the next.
  struct Children {
    Halfedge first, last;
  };

  /// Returns the children of a side whose curve becomes the part `part` of a longer one, with their
  /// new intervals and parent. A leaf is its own only bar, or gets a new one if its half-edge
  /// starts the longer curve.
  Children children_over(Halfedge side, Interval part, Halfedge parent) {
    if (mesh_.is_leaf(side)) {
      const Halfedge bar = part.first == 0 ? bar_instead_of(side) : side;
      if (bar == side) clear_curve(bar);
      HalfedgeRecord& record = edit(bar);
      record.interval = part;
      record.parent = parent;
      record.next_sibling = {};
      return {bar, bar};
    }
    Children children{mesh_[side].first_child, {}};
    for (const Halfedge child : mesh_.children(side)) {
      HalfedgeRecord& record = edit(child);
      record.interval = {part.first + part.length() * record.interval.first,
                         part.first + part.length() * record.interval.second};
      record.parent = parent;
      children.last = child;
    }
    edit(children.last).interval.second = part.second;
    return children;
  }

  /// Returns a new leaf in the place of `side`, which is about to become a parent.
  Halfedge bar_instead_of(Halfedge side) {
    const HalfedgeRecord record = mesh_[side];
    HalfedgeRecord copy;
    copy.origin = record.origin;
    copy.next = record.next;
    copy.prev = record.prev;
    copy.face = record.face;
    const Halfedge bar = journal_.add(copy);
    take_corner(bar, side);
    edit(record.next).prev = bar;
    edit(record.prev).next = bar;
    if (mesh_[record.face].halfedge == side) journal_.edit(record.face).halfedge = bar;
    HalfedgeRecord& parent = edit(side);
    parent.next = parent.prev = {};
    parent.face = {};
    return bar;
  }

  void clear_curve(Halfedge bar) {
    HalfedgeRecord& record = edit(bar);
    record.twin = {};
    record.handles = {};
  }

  void hang_stem(Halfedge stem, Halfedge parent, double t, Halfedge bar_after) {
    PointRecord& p = journal_.edit(mesh_.origin(stem));
    p.stem = p.halfedge = stem;
    HalfedgeRecord& record = edit(stem);
    record.parent = parent;
    record.interval = {t, t};
    record.next_sibling = bar_after;
    // In `bicubic` the patches at the stem keep their colours there, as in the authors' program;
    // the colour of the parent's curve, whose tangents say little of it, could be anywhere.
    if (mesh_.color_model() == ColorModel::bicubic) return;
    edit(mesh_.first_leaf(stem)).own_color = false;
    edit(bar_after).own_color = false;
  }

  void take_corner(Halfedge to, Halfedge from) {
    const HalfedgeRecord corner = mesh_[from];
    HalfedgeRecord& record = edit(to);
    record.twist = corner.twist;
    record.color = corner.color;
    record.own_color = corner.own_color;
  }

  /// Scales the outer tangents for one curve instead of two that meet at t (Eq. 5), and removes the
  /// inner handles.
  void join_handles(Halfedge in, Halfedge out, double t) {
    const std::array<Handle, 2> first = mesh_[in].handles, second = mesh_[out].handles;
    journal_.edit(first[0]).tangent *= 1 / t;
    journal_.edit(second[1]).tangent *= 1 / (1 - t);
    journal_.remove(first[1]);
    journal_.remove(second[0]);
    edit(in).handles = {first[0], second[1]};
    const Halfedge back = mesh_[out].twin;
    if (back.valid()) edit(back).handles = {second[1], first[0]};
  }

  /// Scales the outer own tangents of two bars (Eq. 5), for one bar instead, which is `in`.
  void join_own_tangents(Halfedge in, Halfedge out, double t) {
    const glm::dvec4 end = mesh_[out].own_tangents[1] / (1 - t);
    std::array<glm::dvec4, 2>& own = edit(in).own_tangents;
    own = {own[0] / t, end};
  }

  void close_loop(Face face, const std::array<Halfedge, 4>& loop) {
    for (int k = 0; k < 4; ++k) {
      HalfedgeRecord& record = edit(loop[k]);
      record.face = face;
      record.next = loop[(k + 1) % 4];
      record.prev = loop[(k + 3) % 4];
    }
  }

  void remove_curve(Halfedge side) {
    for (const Handle handle : mesh_[side].handles) journal_.remove(handle);
    journal_.remove(mesh_[side].twin);
    journal_.remove(side);
  }

  Journal& journal_;
  const Mesh& mesh_;
  const Halfedge edge_, twin_;
};

}  // namespace

void merge(Journal& journal, Halfedge edge) {
  assert(can_merge(journal.mesh(), edge) == MergeObstacle::none);
  journal.begin();
  Merge(journal, edge).run();
}

}  // namespace gradmesh
