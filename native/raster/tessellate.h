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

/// Returns twice the area of a triangle, in grid units; positive if the vertices run clockwise, y
/// pointing down.
inline std::int64_t doubled_area(const Vertex& a, const Vertex& b, const Vertex& c) {
  return std::int64_t(b.x - a.x) * (c.y - a.y) - std::int64_t(c.x - a.x) * (b.y - a.y);
}

/// How to get from the parameters that triangles give to those of the surface, by Newton's method.
struct Refinement {
  bool needed = false;
  /// Unless `everywhere`, refinement is needed in cell (i, j) of Folds if bit j of cells[i] is set.
  bool everywhere = true;
  std::array<std::int32_t, Folds::cells> cells;
  /// The pixel from which `position` counts.
  int x = 0, y = 0;
  /// Coefficients of u^i v^j of the position in pixels; first x, then y.
  std::array<Bicubic<float>, 2> position;
  /// most[a][b] is a bound of the derivative of order a along u and b along v, in pixels, where a +
  /// b is from 2 to 4; of shapes that are not traced only where a + b is 2.
  std::array<std::array<float, 4>, 4> most = {};
  /// Coefficients a, b, c with which a + b x + c y is about u (or v) of a pixel.
  std::array<float, 3> start_u, start_v;
};

/// A patch as the pixels inside its outline or, where it may fold, cut into triangles.
struct FaceShape {
  /// True if `spans` holds the covered pixels, by rows; then there are no triangles, and the
  /// vertices are those of the outline.
  bool traced = false;
  std::vector<Span> spans;
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  /// True if triangles may overlap.
  bool may_fold = false;
  /// The pixels that the shape may cover.
  Window bounds;
  Refinement refinement;
};

/// Finds the pixels of patches. Their outlines are within `flatness` of the curves. A patch that
/// surely does not fold covers what lies inside its outline; others are cut into triangles, from
/// the outline to a grid inside:
/// - where the patch surely does not fold, triangles are few: they give the pixels that it covers
///   and about their parameters, which a step of Newton's method then brings to a fraction of
///   `flatness`;
/// - elsewhere triangles are within a tenth of a pixel of the surface.
class Tessellator {
 public:
  /// Starts anew for the mesh as it is now.
  void start(const Mesh& mesh, const Frame& frame);
  /// Finds the shape of a face. `patch` is the face's patch as it is to be painted. The shape has
  /// empty bounds if it meets no pixel of `window`.
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
  std::vector<SubpixelPoint> polygon_;
  SpanTracer tracer_;
};

}  // namespace gradmesh
