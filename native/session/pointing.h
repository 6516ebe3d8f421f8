#pragma once

#include <optional>
#include <vector>

#include "base/affine.h"
#include "mesh/mesh.h"

namespace gradmesh {

/// What of a mesh lies where a person points.
struct Pointed {
  /// The patch, and the place in it, from 0 to 1 along its top side and along its left side.
  Face face;
  double along_top = 0, along_left = 0;
  /// The leaf of an inner curve within reach, the closest; invalid if there is none.
  Halfedge edge;
};

/// Returns what lies at a place, in pixels; nothing beside the mesh. `reach` is the distance in
/// pixels within which a curve counts.
std::optional<Pointed> pointed_at(const Mesh& mesh, const Affine& to_pixels, glm::dvec2 place,
                                  double reach);

/// Returns points of a curve, close enough to each other to be joined by straight lines.
std::vector<glm::dvec2> points_along(const Cubic<Value>& curve, const Affine& to_pixels);

/// Returns the patches of which a closed line of points in pixels surrounds at least a third, by
/// samples; if there is none, the patch of which it surrounds most.
std::vector<Face> faces_covered(const Mesh& mesh, const Affine& to_pixels,
                                const std::vector<glm::dvec2>& lasso);

/// Returns the patches that a line of points in pixels touches.
std::vector<Face> faces_touched(const Mesh& mesh, const Affine& to_pixels,
                                const std::vector<glm::dvec2>& line);

}  // namespace gradmesh
