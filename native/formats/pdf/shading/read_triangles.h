#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "formats/pdf/shading/packing.h"

namespace gradmesh {

struct ShadingVertex {
  glm::dvec2 place{0.0};
  Components color;

  bool operator==(const ShadingVertex&) const = default;
};

using ShadingTriangle = std::array<ShadingVertex, 3>;

struct ShadingTriangles {
  std::vector<ShadingTriangle> triangles;
  /// How many there are, those included that were not kept.
  std::size_t count = 0;
  /// Whether the data end within a triangle, or one continues a triangle that is not there: what
  /// lies before that was read.
  bool is_damaged = false;
};

/// Reads the triangles of a shading of type 4, and keeps the first `most`, at least one, of them.
/// The packing has passed check().
ShadingTriangles read_triangles(std::string_view data, const Packing& packing, std::size_t most);

/// Rows of as many vertices each.
struct ShadingLattice {
  std::size_t columns = 0;
  std::vector<ShadingVertex> vertices;
  /// How many rows there are, those included that were not kept.
  std::size_t rows = 0;
  /// Whether the data end within a row, which is left out.
  bool is_damaged = false;
};

/// Reads the vertices of a shading of type 5 with so many in a row, at least 2, and keeps the first
/// `most` of them. The packing has passed check().
ShadingLattice read_lattice(std::string_view data, const Packing& packing, std::size_t columns,
                            std::size_t most);

}  // namespace gradmesh
