#include "ops/split/without_faces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/build.h"
#include "mesh/subdivide.h"
#include "ops/split/split.h"

namespace gradmesh {
namespace {

class FaceRemover {
 public:
  FaceRemover(Mesh mesh, const std::vector<Face>& faces)
      : mesh_(std::move(mesh)), journal_(mesh_), removed_(mesh_.face_slots()) {
    for (const Face f : faces) removed_[std::size_t(f.value)] = true;
    places_.resize(mesh_.face_slots());
    std::iota(places_.begin(), places_.end(), 0);
  }

  Mesh run() {
    for (bool again = true; again;) {
      again = false;
      for (std::size_t i = 0; i < mesh_.halfedge_slots(); ++i)
        again = split_beside(Halfedge{int(i)}) || again;
    }
    return build_derived_mesh(parts());
  }

 private:
  bool is_removed(Halfedge leaf) const {
    return removed_[std::size_t(places_[std::size_t(mesh_.face(leaf).value)])];
  }

  /// Splits faces across the curve side where it begins or ends to have a face.
  bool split_beside(Halfedge side) {
    if (!mesh_[side].alive || !mesh_.is_parent(side) || !mesh_[side].twin.valid()) return false;
    bool any = false;
    const std::vector<Halfedge> leaves = mesh_.leaves(side).list();
    for (std::size_t k = 1; k < leaves.size(); ++k)
      if (is_removed(leaves[k - 1]) != is_removed(leaves[k]))
        any = split_across(mesh_[side].twin, 1 - mesh_.span(leaves[k]).first) || any;
    return any;
  }

  /// Splits the face at a place on the curve side, if it stays and the place is inside of its side.
  bool split_across(Halfedge side, double at) {
    for (const Halfedge leaf : mesh_.leaves(side).list()) {
      const auto [first, second] = mesh_.span(leaf);
      if (at <= first + same_place || at >= second - same_place || is_removed(leaf)) continue;
      places_.push_back(places_[std::size_t(mesh_.face(leaf).value)]);
      split(journal_, leaf, (at - first) / (second - first));
      return true;
    }
    return false;
  }

  MeshParts parts() const {
    MeshParts all = subdivided(mesh_, 1), left;
    left.color_model = all.color_model;
    std::vector<int> order;
    for (int f = 0; f < int(all.patches.size()); ++f)
      if (!removed_[std::size_t(places_[std::size_t(f)])]) order.push_back(f);
    std::ranges::stable_sort(order, {}, [&](int f) { return places_[std::size_t(f)]; });
    std::vector<int> numbers(all.patches.size(), -1);
    for (const int f : order) {
      numbers[std::size_t(f)] = int(left.patches.size());
      left.patches.push_back(all.patches[std::size_t(f)]);
    }
    // Returns false if the face of the half-edge is removed.
    const auto renumber = [&](int& h) {
      const int number = numbers[std::size_t(h / 4)];
      h = 4 * number + h % 4;
      return number >= 0;
    };
    for (CurveParts& curve : all.curves) {
      bool stays = true;
      for (CurveSide* side : {&curve.a, &curve.b})
        for (int& h : side->halfedges) stays = renumber(h) && stays;
      if (stays) left.curves.push_back(std::move(curve));
    }
    for (int h : all.own_colors)
      if (renumber(h)) left.own_colors.push_back(h);
    return left;
  }

  Mesh mesh_;
  Journal journal_;
  std::vector<bool> removed_;
  /// For each face the one of before of which it is a part.
  std::vector<int> places_;
};

}  // namespace

Mesh without_faces(Mesh mesh, const std::vector<Face>& faces) {
  return FaceRemover(std::move(mesh), faces).run();
}

}  // namespace gradmesh
