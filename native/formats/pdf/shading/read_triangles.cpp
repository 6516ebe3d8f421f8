#include "formats/pdf/shading/read_triangles.h"

#include <optional>
#include <utility>

namespace gradmesh {
namespace {

std::optional<ShadingVertex> read_vertex(ShadingReader& data) {
  const auto place = data.point();
  auto color = place ? data.color() : std::nullopt;
  if (!color) return {};
  return ShadingVertex{*place, *std::move(color)};
}

/// Reads a vertex with a flag before it, whatever that is. Of the three vertices of a new triangle
/// all have one, but only that of the first counts (ISO 32000-1, 8.7.4.5.5).
std::optional<std::pair<int, ShadingVertex>> read_flagged(ShadingReader& data) {
  const auto flag = data.flag();
  auto vertex = flag ? read_vertex(data) : std::nullopt;
  data.end_record();
  if (!vertex) return {};
  return std::pair(*flag, *std::move(vertex));
}

/// Returns the triangle that begins with a vertex and its flag; nothing if the data end first, or
/// it continues a triangle that is not there.
std::optional<ShadingTriangle> triangle_from(ShadingReader& data, int flag, ShadingVertex vertex,
                                             const std::optional<ShadingTriangle>& last) {
  if (flag == 0) {
    auto second = read_flagged(data);
    auto third = second ? read_flagged(data) : std::nullopt;
    if (!third) return {};
    return ShadingTriangle{std::move(vertex), std::move(second->second), std::move(third->second)};
  }
  // A flag of 3 means nothing.
  if (flag == 3 || !last) return {};
  return ShadingTriangle{(*last)[flag == 1 ? 1 : 0], (*last)[2], std::move(vertex)};
}

}  // namespace

ShadingTriangles read_triangles(std::string_view bytes, const Packing& packing, std::size_t most) {
  ShadingTriangles read;
  ShadingReader data(bytes, packing);
  std::optional<ShadingTriangle> last;
  while (data.has_more()) {
    const bool would_be_missed = data.has_much_more();
    auto first = read_flagged(data);
    auto triangle =
        first ? triangle_from(data, first->first, std::move(first->second), last) : std::nullopt;
    if (!triangle) {
      read.is_damaged = would_be_missed;
      break;
    }
    last = std::move(triangle);
    if (read.count++ < most) read.triangles.push_back(*last);
  }
  return read;
}

ShadingLattice read_lattice(std::string_view bytes, const Packing& packing, std::size_t columns,
                            std::size_t most) {
  ShadingLattice read{columns, {}};
  std::size_t count = 0;
  ShadingReader data(bytes, packing);
  while (data.has_more()) {
    const bool would_be_missed = data.has_much_more();
    auto vertex = read_vertex(data);
    data.end_record();
    if (!vertex) {
      read.is_damaged = would_be_missed;
      break;
    }
    if (count++ < most) read.vertices.push_back(*std::move(vertex));
  }
  read.rows = count / columns;
  read.is_damaged = read.is_damaged || count % columns > 0;
  read.vertices.resize(read.vertices.size() - read.vertices.size() % columns);
  return read;
}

}  // namespace gradmesh
