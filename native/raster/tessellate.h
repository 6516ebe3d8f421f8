#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "mesh/mesh.h"
#include "raster/frame.h"

namespace gradmesh {

/// Vertices lie on a grid of 1/256 of a pixel, so that which pixels a triangle covers can be
/// decided exactly.
constexpr int subpixel_bits = 8;

struct Vertex {
  std::int64_t x, y;
  float u, v;
};

using Triangle = std::array<Vertex, 3>;

/// Where the curves are cut into straight pieces. Both sides of a curve, and all the patches
/// along it, share the same cuts, its T-junctions among them: so neighbours leave no gap.
class Outlines {
 public:
  Outlines(const Mesh& mesh, const Frame& frame) : mesh_(mesh), frame_(frame) {}

  struct Cut {
    double t;
    glm::dvec2 position;
  };

  /// Works out the cuts of the curve of `leaf`, once.
  void prepare(Halfedge leaf);
  /// The cuts along a leaf in its own direction and parameter, both ends among them. Its curve
  /// must be prepared.
  std::vector<Cut> along(Halfedge leaf) const;

 private:
  const Mesh& mesh_;
  const Frame& frame_;
  std::map<Halfedge, std::vector<Cut>> cuts_;
};

/// Triangles that cover a patch, from its outlines to a grid inside, in the order in which they
/// are to be painted. They are within a tenth of a pixel of the surface.
std::vector<Triangle> tessellate(const Mesh& mesh, Face face, const Patch& patch,
                                 const Frame& frame, const Outlines& outlines);

}  // namespace gradmesh
