#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.h"

namespace gradmesh {

/// A set of patches of a mesh, a bit each, so that overlaps are found many patches at a time.
class PatchSet {
 public:
  explicit PatchSet(std::size_t face_slots) : words_((face_slots + 63) / 64) {}

  void add(Face f) { words_[std::size_t(f.value) / 64] |= std::uint64_t(1) << (f.value % 64); }
  /// Adds the patches of another set, which must be of the same mesh.
  void add(const PatchSet& other) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
  }
  bool overlaps(const PatchSet& other) const {
    for (std::size_t i = 0; i < words_.size(); ++i)
      if (words_[i] & other.words_[i]) return true;
    return false;
  }
  bool contains(Face f) const { return words_[std::size_t(f.value) / 64] >> (f.value % 64) & 1; }
  std::size_t face_slots() const { return 64 * words_.size(); }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace gradmesh
