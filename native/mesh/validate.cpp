#include "mesh/validate.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mesh/dependence.h"

namespace gradmesh {
namespace {

bool finite(const Value& v) {
  return std::isfinite(v.position.x) && std::isfinite(v.position.y) &&
         std::isfinite(v.color.r + v.color.g + v.color.b + v.color.a);
}

class Validator {
 public:
  explicit Validator(const Mesh& mesh) : mesh_(mesh) {}

  std::vector<std::string> run() {
    check_indices();
    // Without sound references the rest could not even be walked.
    if (!broken_.empty()) return broken_;
    for (const Face f : mesh_.faces()) check_face(f);
    for (const Halfedge h : mesh_.halfedges()) check_halfedge(h);
    if (!broken_.empty()) return broken_;
    for (const Point p : mesh_.points()) check_point(p);
    if (has_cycle(mesh_)) fail("cycle", "a curve", 0);
    for (const Halfedge h : mesh_.halfedges())
      if (mesh_.is_stem(h)) check_junction(h);
    check_finite();
    if (std::ranges::distance(mesh_.faces()) != mesh_.face_count())
      fail("count", "faces", mesh_.face_count());
    return broken_;
  }

 private:
  void fail(const char* name, const char* what, int index) {
    broken_.push_back(std::string(name) + ": " + what + " " + std::to_string(index));
  }
  void require(bool holds, const char* name, Halfedge h) {
    if (!holds) fail(name, "halfedge", h.value);
  }

  template <class Element>
  bool alive(Element e, std::size_t slots) const {
    return e.valid() && std::size_t(e.value) < slots && mesh_[e].alive;
  }

  void check_indices() {
    const std::size_t halfedges = mesh_.halfedge_slots(), faces = mesh_.face_slots();
    const auto ok = [&](Halfedge h) { return alive(h, halfedges); };
    for (const Face f : mesh_.faces())
      if (!ok(mesh_[f].halfedge)) fail("indices", "face", f.value);
    for (const Point p : mesh_.points()) {
      if (!ok(mesh_[p].halfedge)) fail("indices", "point", p.value);
      if (mesh_[p].stem.valid() && !ok(mesh_[p].stem)) fail("indices", "point", p.value);
    }
    for (const Halfedge h : mesh_.halfedges()) {
      const HalfedgeRecord& r = mesh_[h];
      bool good = r.origin.valid() && mesh_[r.origin].alive;
      for (const Halfedge other : {r.twin, r.parent, r.first_child, r.next_sibling})
        good = good && (!other.valid() || ok(other));
      for (const Handle handle : r.handles) good = good && (!handle.valid() || mesh_[handle].alive);
      if (!r.first_child.valid()) good = good && ok(r.next) && ok(r.prev) && alive(r.face, faces);
      require(good, "indices", h);
    }
  }

  void check_face(Face f) {
    Halfedge h = mesh_[f].halfedge;
    for (int k = 0; k < 4; ++k) {
      if (!mesh_.is_leaf(h) || mesh_.face(h) != f || mesh_.prev(mesh_.next(h)) != h)
        return fail("face", "face", f.value);
      h = mesh_.next(h);
    }
    if (h != mesh_[f].halfedge) fail("face", "face", f.value);
  }

  void check_halfedge(Halfedge h) {
    const HalfedgeRecord& r = mesh_[h];
    if (mesh_.is_parent(h)) {
      require(!r.face.valid() && !r.next.valid() && !r.prev.valid(), "leaf", h);
      require(r.twin.valid(), "twin", h);
      check_children(h);
    } else {
      check_face_of(h);
    }
    if (mesh_.is_bar(h)) {
      require(mesh_.is_leaf(h) && !r.twin.valid() && !r.handles[0].valid() && !r.handles[1].valid(),
              "bar", h);
    } else {
      check_curve_side(h);
    }
  }

  void check_face_of(Halfedge leaf) {
    const std::array<Halfedge, 4> sides = mesh_.sides(mesh_.face(leaf));
    require(std::ranges::find(sides, leaf) != sides.end(), "face", leaf);
  }

  void check_curve_side(Halfedge h) {
    const HalfedgeRecord& r = mesh_[h];
    require(r.handles[0].valid() && r.handles[1].valid() && r.handles[0] != r.handles[1], "handles",
            h);
    if (r.handles[0].valid()) require(mesh_[r.handles[0]].halfedge == h, "handles", h);
    if (!r.twin.valid()) return;
    const HalfedgeRecord& t = mesh_[r.twin];
    require(r.twin != h && t.twin == h && !mesh_.is_bar(r.twin), "twin", h);
    require(t.handles[0] == r.handles[1] && t.handles[1] == r.handles[0], "handles", h);
    require(mesh_.origin(r.twin) == mesh_.origin(mesh_.next(mesh_.last_leaf(h))), "twin", h);
  }

  void check_children(Halfedge parent) {
    const std::vector<Halfedge> children = mesh_.children(parent).list();
    bool good = children.size() >= 3 && children.size() % 2 == 1;
    double at = 0;
    for (std::size_t i = 0; good && i < children.size(); ++i) {
      const Halfedge c = children[i];
      const Interval interval = mesh_[c].interval;
      good = mesh_[c].parent == parent && interval.first == at && interval.second <= 1;
      good = good && mesh_.is_bar(c) == (i % 2 == 0);
      if (good && i % 2 == 1)
        good = mesh_.curve_side(mesh_.next(children[i - 1])) == c &&
               mesh_.origin(c) == mesh_.origin(children[i + 1]);
      at = interval.second;
    }
    good = good && at == 1 && mesh_.origin(children[0]) == mesh_.origin(parent);
    require(good, "children", parent);
  }

  void check_point(Point p) {
    const Halfedge h = mesh_[p].halfedge;
    if (mesh_.origin(h) != p || mesh_.is_bar(h)) fail("point", "point", p.value);
    const Halfedge stem = mesh_[p].stem;
    if (stem.valid() && (!mesh_.is_stem(stem) || mesh_.origin(stem) != p))
      fail("junction", "point", p.value);
  }

  void check_junction(Halfedge stem) {
    const Point p = mesh_.origin(stem);
    require(mesh_[p].stem == stem, "junction", stem);
    const Value value = junction_value(mesh_, stem);
    const double off = glm::length(value.position - mesh_.position(p));
    require(off <= 1e-9 * (1 + glm::length(value.position)), "junction", stem);
    for (const Halfedge leaf : {mesh_.first_leaf(stem), mesh_[stem].next_sibling})
      if (!mesh_[leaf].own_color)
        require(glm::length(mesh_[leaf].color - value.color) <= 1e-9, "color", leaf);
  }

  void check_finite() {
    for (const Face f : mesh_.faces()) {
      const Patch patch = mesh_.patch(f);
      bool good = true;
      for (const auto& row : patch.c)
        for (const Value& v : row) good = good && finite(v);
      if (!good) fail("finite", "face", f.value);
    }
  }

  const Mesh& mesh_;
  std::vector<std::string> broken_;
};

}  // namespace

std::vector<std::string> validate(const Mesh& mesh) { return Validator(mesh).run(); }

}  // namespace gradmesh
