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
                                             const std::vector<ShadingTriangle>& before) {
  if (flag == 0) {
    auto second = read_flagged(data);
    auto third = second ? read_flagged(data) : std::nullopt;
    if (!third) return {};
    return ShadingTriangle{std::move(vertex), std::move(second->second), std::move(third->second)};
  }
  // A flag of 3 means nothing.
  if (flag == 3 || before.empty()) return {};
  const ShadingTriangle& last = before.back();
  return ShadingTriangle{last[flag == 1 ? 1 : 0], last[2], std::move(vertex)};
}

}  // namespace

ShadingTriangles read_triangles(std::string_view bytes, const Packing& packing, std::size_t most) {
  ShadingTriangles read;
  ShadingReader data(bytes, packing);
  while (data.has_more() && read.triangles.size() < most) {
    const bool would_be_missed = data.has_much_more();
    auto first = read_flagged(data);
    auto triangle =
        first ? triangle_from(data, first->first, std::move(first->second), read.triangles)
              : std::nullopt;
    if (!triangle) {
      read.is_damaged = would_be_missed;
      break;
    }
    read.triangles.push_back(*std::move(triangle));
  }
  return read;
}

ShadingLattice read_lattice(std::string_view bytes, const Packing& packing, std::size_t columns,
                            std::size_t most) {
  ShadingLattice read{columns, {}};
  ShadingReader data(bytes, packing);
  while (data.has_more() && read.vertices.size() < most) {
    const bool would_be_missed = data.has_much_more();
    auto vertex = read_vertex(data);
    data.end_record();
    if (!vertex) {
      read.is_damaged = would_be_missed;
      break;
    }
    read.vertices.push_back(*std::move(vertex));
  }
  const std::size_t left_over = read.vertices.size() % columns;
  read.is_damaged = read.is_damaged || left_over > 0;
  read.vertices.resize(read.vertices.size() - left_over);
  return read;
}

}  // namespace gradmesh
