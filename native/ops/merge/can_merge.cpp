#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "ops/merge/merge.h"
#include "ops/merge/merge_end.h"

namespace gradmesh {
namespace {

/// Looks for the cycle that a merge would make, in the mesh as it would be (4.4): at each interior
/// end two curves are one, and the curve across starts on it as a stem.
class CycleSearch {
 public:
  CycleSearch(const Mesh& mesh, const MergeEnd& tail, const MergeEnd& head) : mesh_(mesh) {
    for (const MergeEnd& end : {tail, head})
      if (end.kind == MergeEnd::interior)
        combined_[count_++] = {mesh.curve_side(end.in), mesh.curve_side(end.out), end.across};
  }

  MergeObstacle run() {
    for (const Combined& c : all_combined())
      for (const Halfedge start : {c.in, other(c.in)}) {
        std::vector<Halfedge> seen;
        const MergeObstacle found = follow(start, start, seen, true);
        if (found != MergeObstacle::none) return found;
      }
    return MergeObstacle::none;
  }

 private:
  /// The curve made of `in` and `out`. `in` is the name of one of its sides, the twin of `out` that
  /// of the other.
  struct Combined {
    Halfedge in, out, across;
  };

  std::span<const Combined> all_combined() const { return {combined_.data(), count_}; }

  Halfedge name(Halfedge side) const {
    for (const Combined& c : all_combined()) {
      if (side == c.out) return c.in;
      if (side == mesh_[c.in].twin) return mesh_[c.out].twin;
    }
    return side;
  }
  const Combined* combined(Halfedge side) const {
    for (const Combined& c : all_combined())
      if (side == c.in || side == mesh_[c.out].twin) return &c;
    return nullptr;
  }
  Halfedge other(Halfedge side) const {
    const Combined* c = combined(side);
    if (!c) return mesh_[side].twin;
    return side == c->in ? mesh_[c->out].twin : c->in;
  }

  /// Returns the side on which the curve starts as a stem, seen from `side`; invalid where it does
  /// not.
  Halfedge support(Halfedge side) const {
    for (const Combined& c : all_combined())
      if (side == name(c.across)) return mesh_[c.out].twin;
    // A combined side starts where its own half-edge or, for the other side, `out`'s twin starts.
    return mesh_.is_stem(side) ? name(mesh_[side].parent) : Halfedge{};
  }

  /// Follows the curves on which the start of `side` depends, directly or not, until it reaches the
  /// curve of `start`. `by_starts` is true if each step so far went from the start of a side to the
  /// side on which it lies, and from there to that same side's start.
  MergeObstacle follow(Halfedge side, Halfedge start, std::vector<Halfedge>& seen,
                       bool by_starts) const {
    const Halfedge parent = support(side);
    if (!parent.valid()) return MergeObstacle::none;
    const Halfedge back = other(parent);
    if (parent == start || back == start)
      return by_starts && parent == start ? MergeObstacle::origin_cycle : MergeObstacle::next_cycle;
    const Halfedge curve = std::min(parent, back);
    if (std::ranges::find(seen, curve) != seen.end()) return MergeObstacle::none;
    seen.push_back(curve);
    const MergeObstacle found = follow(parent, start, seen, by_starts);
    return found != MergeObstacle::none ? found : follow(back, start, seen, false);
  }

  const Mesh& mesh_;
  std::array<Combined, 2> combined_;
  std::size_t count_ = 0;
};

/// Returns true if the sides that the merge joins or keeps are not all on curves of their own.
bool meets_itself(const Mesh& mesh, Halfedge edge, const MergeEnd& tail, const MergeEnd& head) {
  const Halfedge twin = mesh[edge].twin;
  if (mesh.face(edge) == mesh.face(twin) || mesh.origin(edge) == mesh.origin(twin)) return true;
  std::array<Halfedge, 4> joined;
  std::size_t count = 0;
  const auto is_joined = [&](Halfedge h) {
    const auto end = joined.begin() + count;
    return std::find(joined.begin(), end, mesh.curve(h)) != end;
  };
  const auto join = [&](Halfedge h) {
    if (is_joined(h)) return false;
    joined[count++] = mesh.curve(h);
    return true;
  };
  for (const MergeEnd* end : {&tail, &head})
    if (!join(end->in) || (end->kind != MergeEnd::stem && !join(end->out))) return true;
  for (const MergeEnd* end : {&tail, &head})
    if (end->kind == MergeEnd::interior && is_joined(end->across)) return true;
  return is_joined(edge) || is_joined(mesh.next(head.out)) || is_joined(mesh.next(tail.out));
}

/// Looks for patches that must stay as they are beside curves that a merge changes.
class FixedSearch {
 public:
  explicit FixedSearch(const Mesh& mesh) : mesh_(mesh) {}

  bool is_beside(Halfedge side) const {
    for (const Halfedge leaf : mesh_.leaves(side))
      if (mesh_.is_fixed(mesh_.face(leaf))) return true;
    return false;
  }

  /// Returns true if one lies beside the curve of a half-edge, or beside a curve that depends on
  /// it: T-junctions move with the curve on which they lie, and the stems that start there.
  bool is_reached(Halfedge halfedge) {
    const Halfedge curve = mesh_.curve(halfedge);
    if (std::ranges::find(seen_, curve) != seen_.end()) return false;
    seen_.push_back(curve);
    for (const Halfedge side : {curve, mesh_[curve].twin}) {
      if (!side.valid()) continue;
      if (is_beside(side)) return true;
      if (!mesh_.is_parent(side)) continue;
      for (const Halfedge stem : mesh_.stems(side))
        if (is_reached(stem)) return true;
    }
    return false;
  }

 private:
  const Mesh& mesh_;
  std::vector<Halfedge> seen_;
};

/// Returns true if a merge changes a patch that must stay as it is, or a curve beside one: at an
/// end that is no T-junction of its own two curves become one.
bool changes_fixed(const Mesh& mesh, Halfedge edge, const MergeEnd& tail, const MergeEnd& head) {
  FixedSearch search(mesh);
  if (search.is_beside(edge) || search.is_beside(mesh[edge].twin)) return true;
  for (const MergeEnd* end : {&tail, &head}) {
    if (end->kind == MergeEnd::stem) continue;
    if (search.is_reached(end->in) || search.is_reached(end->out)) return true;
    if (end->kind == MergeEnd::interior && search.is_reached(end->across)) return true;
  }
  return false;
}

}  // namespace

Message describe(MergeObstacle obstacle) {
  const Message texts[] = {
      Message("it can be merged"),
      Message("it is on the boundary of the mesh"),
      Message("a T-junction divides it"),
      Message("it is part of a longer curve"),
      Message("a curve would end on itself"),
      Message("a curve would start on itself"),
      Message("it meets a branch point, which must stay"),
      Message("its two patches meet themselves round a ring"),
      Message("a patch there is protected"),
  };
  return texts[std::size_t(obstacle)];
}

MergeObstacle can_merge(const Mesh& mesh, Halfedge edge) {
  if (mesh.is_parent(edge)) return MergeObstacle::parent;
  if (mesh.is_bar(edge)) return MergeObstacle::bar;
  const Halfedge twin = mesh[edge].twin;
  if (!twin.valid()) return MergeObstacle::boundary;
  if (mesh.is_parent(twin)) return MergeObstacle::parent;

  const MergeEnd tail = merge_end(mesh, edge), head = merge_end(mesh, twin);
  if (meets_itself(mesh, edge, tail, head)) return MergeObstacle::ring;
  if (tail.kind == MergeEnd::branch || head.kind == MergeEnd::branch) return MergeObstacle::branch;
  if (changes_fixed(mesh, edge, tail, head)) return MergeObstacle::fixed;
  return CycleSearch(mesh, tail, head).run();
}

}  // namespace gradmesh
