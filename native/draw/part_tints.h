#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "methods/merging/motorcycle.h"

namespace gradmesh {

/// How much of what lies below is covered by a part's tint.
inline constexpr double part_opacity = 0.45;
/// The tint of the first part, as sRGB in 0..1.
extern const glm::dvec3 first_part_color;

/// The parts of a motorcycle graph in tints that can be distinguished beside each other, also
/// without seeing red or green.
class PartTints {
 public:
  PartTints(const Mesh& mesh, const MotorcycleGraph& graph);

  /// Returns the index of the part that a face belongs to, -1 for none. A patch belongs to the part
  /// of any of its edges.
  int part(Face face) const { return part_[std::size_t(face.value)]; }
  /// Returns the tint of a part as sRGB in 0..1: the first that none of its neighbours before it
  /// has, if there is one.
  const glm::dvec3& color(int part) const;

 private:
  /// By slots of faces.
  std::vector<int> part_;
  /// By parts.
  std::vector<int> tint_;
};

}  // namespace gradmesh
