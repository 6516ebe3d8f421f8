#include "formats/hemesh/hemesh.h"

#include <algorithm>
#include <cassert>
#include <map>

#include "formats/hemesh/hemesh_file.h"

namespace gradmesh {
namespace {

/// Writes the records. Half-edge 4 * face + side is side `side` of a face; parents follow in the
/// order of their first bars, points and handles in the order in which half-edges meet them.
class HemeshWriter {
 public:
  explicit HemeshWriter(const Mesh& mesh) : mesh_(mesh), number_(mesh.halfedge_slots(), -1) {}

  HemeshFile write() {
    number_halfedges();
    for (const Halfedge h : order_)
      if (!mesh_.is_bar(h)) add_side(h);
    for (const Halfedge h : order_) file_.halfedges.push_back(record(h));
    return std::move(file_);
  }

 private:
  int number(Halfedge h) const { return h.valid() ? number_[std::size_t(h.value)] : -1; }

  void number_halfedges() {
    for (const Face f : mesh_.faces()) {
      file_.patches.push_back(int(order_.size()));
      for (const Halfedge h : mesh_.sides(f)) add(h);
    }
    const std::size_t leaves = order_.size();
    for (std::size_t i = 0; i < leaves; ++i) {
      const Halfedge side = mesh_.curve_side(order_[i]);
      if (number(side) < 0) add(side);
    }
  }
  void add(Halfedge h) {
    number_[std::size_t(h.value)] = int(order_.size());
    order_.push_back(h);
  }

  /// Adds the control point where a side starts and, once for each curve, the curve's handles.
  void add_side(Halfedge side) {
    const Point p = mesh_.origin(side);
    if (!mesh_[p].is_junction() && point_.try_emplace(p, int(file_.points.size())).second)
      file_.points.push_back({mesh_.position(p), number(side)});
    const HalfedgeRecord& record = mesh_[side];
    if (handle_.contains(record.handles[0])) return;
    const Halfedge after = mesh_.curve_side(mesh_.next(mesh_.last_leaf(side)));
    add_handle(record.handles[0], side);
    add_handle(record.handles[1], record.twin.valid() ? record.twin : after);
  }
  void add_handle(Handle handle, Halfedge start) {
    handle_[handle] = int(file_.handles.size());
    file_.handles.push_back({number(start), mesh_[handle].tangent});
  }

  HemeshFile::Halfedge record(Halfedge h) const {
    const HalfedgeRecord& r = mesh_[h];
    const Halfedge first = mesh_.first_leaf(h), last = mesh_.last_leaf(h);
    HemeshFile::Halfedge record;
    record.twist = mesh_[first].twist;
    record.color = mesh_[first].color;
    if (!mesh_.is_bar(h))
      for (std::size_t end : {0, 1}) record.handles[end] = handle_.at(r.handles[end]);
    // A parent stands beside its first and last bar, and bars repeat the parent's twin: so it is in
    // the authors' files.
    record.twin = number(mesh_.other_side(h));
    record.prev = number(mesh_.prev(first));
    record.next = number(mesh_.next(last));
    record.patch = number(mesh_[mesh_.face(first)].halfedge) / 4;
    record.first_child = number(r.first_child);
    record.is_child = mesh_.is_child(h);
    if (record.is_child) {
      record.parent = number(r.parent);
      record.interval = r.interval;
      const bool at_junction = mesh_.is_stem(h) || mesh_[r.origin].is_junction();
      record.recolored = at_junction && mesh_[first].own_color;
    } else {
      record.origin = point_.at(r.origin);
    }
    return record;
  }

  const Mesh& mesh_;
  HemeshFile file_;
  std::vector<Halfedge> order_;
  std::vector<int> number_;
  std::map<Point, int> point_;
  std::map<Handle, int> handle_;
};

}  // namespace

std::string write_hemesh(const Mesh& mesh) {
  assert(mesh.color_model() == ColorModel::bicubic);
  return format_hemesh(HemeshWriter(mesh).write());
}

}  // namespace gradmesh
