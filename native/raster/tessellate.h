#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "raster/bicubic.h"
#include "raster/folds.h"
#include "raster/outlines.h"

namespace gradmesh {

/// A grid point and where on the patch it lies.
struct Vertex {
  std::int32_t x, y;
  float u, v;
};

/// Indices of three vertices.
using Triangle = std::array<std::uint32_t, 3>;

/// Twice the area, in grid units; positive where the vertices run clockwise, y pointing down.
inline std::int64_t doubled_area(const Vertex& a, const Vertex& b, const Vertex& c) {
  return std::int64_t(b.x - a.x) * (c.y - a.y) - std::int64_t(c.x - a.x) * (b.y - a.y);
}

/// First pixel whose centre is not left of (or above) the grid coordinate.
constexpr int first_pixel(std::int32_t x) {
  constexpr int unit = 1 << subpixel_bits;
  return (x + unit / 2 - 1) >> subpixel_bits;
}

/// How to get from the parameters that triangles give to those of the surface, by Newton's method.
struct Refinement {
  bool needed = false;
  /// Where not `everywhere`, bit j of cells[i] tells whether in cell (i, j) of Folds.
  bool everywhere = true;
  std::array<std::int32_t, Folds::cells> cells;
  /// The pixel from which `position` counts.
  int x = 0, y = 0;
  /// Position in pixels, coefficients of u^i v^j; first x, then y.
  std::array<Bicubic<float>, 2> position;
  /// Most that the second derivatives H_uu, H_uv, H_vv can be, in pixels.
  float uu = 0, uv = 0, vv = 0;
};

/// A patch cut into triangles.
struct FaceShape {
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  /// Whether triangles may overlap.
  bool may_fold = false;
  /// The pixels that they may cover.
  Window bounds;
  Refinement refinement;
};

/// Cuts patches into triangles, from their outlines to a grid inside. The outlines are within
/// `flatness` of the curves. Inside
/// - where the patch surely does not fold triangles are few: they say which pixels it covers and
///   about where on the patch, and a step of Newton's method then says it to a fraction of
///   `flatness`;
/// - elsewhere they are within a tenth of a pixel of the surface.
class Tessellator {
 public:
  /// For the mesh as it is now.
  void start(const Mesh& mesh, const Frame& frame);
  /// `patch` is that of the face as it is to be painted. A shape without triangles where it meets
  /// no pixel of `window`.
  void tessellate(Face face, const Patch& patch, Window window, FaceShape& shape);

 private:
  void cut(Face face, const Bicubic<glm::dvec2>& position, FaceShape& shape);
  void add_side(int side, Halfedge leaf, FaceShape& shape);

  const Mesh* mesh_ = nullptr;
  const Frame* frame_ = nullptr;
  Outlines outlines_;
  /// Parameters of the grid's lines, from 0 to 1.
  std::vector<double> lines_u_, lines_v_;
  std::vector<std::uint32_t> outer_, inner_;
};

}  // namespace gradmesh
