#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "raster/bicubic.h"
#include "raster/folds.h"
#include "raster/outlines.h"
#include "raster/spans.h"

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
  /// Most that the derivative of order a along u and b along v can be, in pixels: most[a][b] for
  /// 2 <= a + b <= 4.
  std::array<std::array<float, 4>, 4> most = {};
  /// About where pixels lie: u (or v) is a + b x + c y.
  std::array<float, 3> start_u, start_v;
};

/// A patch as the pixels inside its outline or, where it may fold, cut into triangles.
struct FaceShape {
  /// Whether `spans` tells the pixels, by rows; then there are no triangles, and the vertices are
  /// those of the outline.
  bool traced = false;
  std::vector<Span> spans;
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  /// Whether triangles may overlap.
  bool may_fold = false;
  /// The pixels that they may cover.
  Window bounds;
  Refinement refinement;
};

/// Finds the pixels of patches. Their outlines are within `flatness` of the curves. Patches that
/// surely do not fold are what lies inside; others are cut into triangles, from the outline to a
/// grid inside:
/// - where the patch surely does not fold triangles are few: they say which pixels it covers and
///   about where on the patch, and a step of Newton's method then says it to a fraction of
///   `flatness`;
/// - elsewhere they are within a tenth of a pixel of the surface.
class Tessellator {
 public:
  /// For the mesh as it is now.
  void start(const Mesh& mesh, const Frame& frame);
  /// `patch` is that of the face as it is to be painted. A shape without bounds where it meets no
  /// pixel of `window`.
  void tessellate(Face face, const Patch& patch, Window window, FaceShape& shape);

 private:
  static Vertex vertex_on(int side, const Outlines::Cut& cut);
  bool trace(Face face, bool clockwise, FaceShape& shape);
  void cut(Face face, const Bicubic<glm::dvec2>& position, FaceShape& shape);
  void add_side(int side, Halfedge leaf, FaceShape& shape);

  const Mesh* mesh_ = nullptr;
  const Frame* frame_ = nullptr;
  Outlines outlines_;
  /// Parameters of the grid's lines, from 0 to 1.
  std::vector<double> lines_u_, lines_v_;
  std::vector<std::uint32_t> outer_, inner_;
  std::vector<GridPoint> polygon_;
  SpanTracer tracer_;
};

}  // namespace gradmesh
