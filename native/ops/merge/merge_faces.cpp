#include "ops/merge/merge_faces.h"

#include <vector>

namespace gradmesh {
namespace {

/// Merges edges between the faces until none of them can be merged any more.
class FacesMerger {
 public:
  FacesMerger(Journal& journal, std::span<const Face> faces)
      : journal_(journal),
        mesh_(journal.mesh()),
        faces_(faces.begin(), faces.end()),
        chosen_(mesh_.face_slots(), false) {
    for (const Face f : faces_) chosen_[std::size_t(f.value)] = true;
  }

  /// Merges edges that are sides `first` and `first + 2` of their patches before the others: a
  /// rectangle is merged row by row or column by column.
  MergedFaces run(int first) {
    while (merge_one(first) || merge_one(first + 1)) {
    }
    if (faces_.size() == 1) return {faces_.front()};
    for (const Face f : faces_)
      for (const Halfedge h : mesh_.sides(f))
        if (neighbour(h).valid() && neighbour(h) != f) return {{}, can_merge(mesh_, h)};
    return {};
  }

 private:
  /// Returns the chosen face on the other side of an edge, one of them where there are several;
  /// invalid where there is none.
  Face neighbour(Halfedge h) const {
    const Halfedge side = mesh_.other_side(h);
    if (!side.valid()) return {};
    for (const Halfedge leaf : mesh_.leaves(side)) {
      const Face f = mesh_.face(leaf);
      if (chosen_[std::size_t(f.value)]) return f;
    }
    return {};
  }

  bool merge_one(int first) {
    for (const Face f : faces_)
      for (const int k : {first, (first + 2) % 4}) {
        const Halfedge h = mesh_.sides(f)[std::size_t(k)];
        const Face other = neighbour(h);
        if (!other.valid() || can_merge(mesh_, h) != MergeObstacle::none) continue;
        merge(journal_, h);
        chosen_[std::size_t(other.value)] = false;
        std::erase(faces_, other);
        return true;
      }
    return false;
  }

  Journal& journal_;
  const Mesh& mesh_;
  std::vector<Face> faces_;
  std::vector<bool> chosen_;
};

}  // namespace

MergedFaces merge_faces(Journal& journal, std::span<const Face> faces) {
  const std::size_t depth = journal.depth();
  MergedFaces merged;
  for (const int first : {1, 0}) {
    merged = FacesMerger(journal, faces).run(first);
    if (merged.face.valid()) return merged;
    journal.undo_to(depth);
  }
  return merged;
}

}  // namespace gradmesh
