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
  /// The closest side of the patch within reach; invalid if there is none.
  Halfedge side = {};
  /// The closest that is a leaf of an inner curve; invalid if there is none.
  Halfedge edge = {};
  /// The side that starts at the closest corner of the patch within reach; invalid if there is
  /// none.
  Halfedge corner = {};
};

/// What a person takes hold of to move it: a point that is no T-junction, or if that is invalid a
/// handle. Straight sides have theirs at the thirds.
struct Grip {
  Point point = {};
  /// The curve of the handle, as Mesh::curve names it, and whether it is the one at its end.
  Halfedge curve = {};
  bool is_at_end = false;
};

/// Returns what lies at a place, in pixels; nothing beside the mesh. `reach` is the distance in
/// pixels within which a curve counts.
std::optional<Pointed> pointed_at(const Mesh& mesh, const Affine& to_pixels, glm::dvec2 place,
                                  double reach);

/// Returns what a person takes hold of at a place, in pixels: the closest point or handle at most
/// `reach` pixels away, a point if both are at one place; nothing if there is none.
std::optional<Grip> grip_at(const Mesh& mesh, const Affine& to_pixels, glm::dvec2 place,
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
