#include "formats/pdf/shading/read_patches.h"

#include <optional>

#include "geom/patch.h"

namespace gradmesh {
namespace {

struct Place {
  std::size_t i, j;
};

/// The control points in the order of the data: around the patch, from (0, 0) along v, and then
/// the inner ones likewise (ISO 32000-1, 8.7.4.5.8).
constexpr std::size_t outer_points = 12, all_points = 16;
constexpr std::array<Place, all_points> order{{{0, 0},
                                               {0, 1},
                                               {0, 2},
                                               {0, 3},
                                               {1, 3},
                                               {2, 3},
                                               {3, 3},
                                               {3, 2},
                                               {3, 1},
                                               {3, 0},
                                               {2, 0},
                                               {1, 0},
                                               {1, 1},
                                               {1, 2},
                                               {2, 2},
                                               {2, 1}}};

glm::dvec2& point_of(ShadingPatch& patch, std::size_t n) {
  return patch.points[order[n].i][order[n].j];
}

void make_inner_points_coons(ShadingPatch& patch) {
  BezierNet net;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) net[i][j].position = patch.points[i][j];
  const auto inner = coons_interior(net);
  for (std::size_t a = 0; a < 2; ++a)
    for (std::size_t b = 0; b < 2; ++b) patch.points[1 + a][1 + b] = inner[a][b];
}

/// Begins a patch at side `flag`, 1 to 3, of the one before.
ShadingPatch beside(ShadingPatch before, int flag) {
  ShadingPatch patch;
  const std::size_t side = std::size_t(flag);
  for (std::size_t n = 0; n < 4; ++n)
    point_of(patch, n) = point_of(before, (3 * side + n) % outer_points);
  patch.colors[0] = before.colors[side];
  patch.colors[1] = before.colors[(side + 1) % 4];
  return patch;
}

/// Reads the points and colours of a patch that are not those of the one before. Returns nothing
/// if the data end first.
std::optional<ShadingPatch> rest_of(ShadingReader& data, ShadingPatch patch, bool is_new,
                                    std::size_t points) {
  for (std::size_t n = is_new ? 0 : 4; n < points; ++n) {
    const auto point = data.point();
    if (!point) return {};
    point_of(patch, n) = *point;
  }
  for (std::size_t n = is_new ? 0 : 2; n < 4; ++n) {
    auto color = data.color();
    if (!color) return {};
    patch.colors[n] = *std::move(color);
  }
  return patch;
}

}  // namespace

ShadingPatches read_patches(std::string_view bytes, const Packing& packing, PatchKind kind,
                            std::size_t most) {
  ShadingPatches read;
  const std::size_t points = kind == PatchKind::coons ? outer_points : all_points;
  for (ShadingReader data(bytes, packing); data.has_more() && read.patches.size() < most;
       data.end_record()) {
    const bool would_be_missed = data.has_much_more();
    const auto flag = data.flag();
    const bool is_new = flag == 0;
    std::optional<ShadingPatch> patch;
    if (flag && (is_new || !read.patches.empty()))
      patch = rest_of(data, is_new ? ShadingPatch() : beside(read.patches.back(), *flag), is_new,
                      points);
    if (!patch) {
      read.is_damaged = would_be_missed;
      break;
    }
    if (kind == PatchKind::coons) make_inner_points_coons(*patch);
    read.patches.push_back(*std::move(patch));
  }
  return read;
}

}  // namespace gradmesh
