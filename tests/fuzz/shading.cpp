#include <algorithm>
#include <cmath>
#include <span>

#include "base/error.h"
#include "choices.h"
#include "formats/pdf/shading/read_patches.h"
#include "formats/pdf/shading/read_triangles.h"
#include "target.h"

namespace gradmesh::fuzz {
namespace {

constexpr std::size_t most = 500, header = 8;

Packing packing_of(Choices& choices) {
  Packing packing;
  packing.coordinate_bits = int(choices.byte() % 34);
  packing.component_bits = int(choices.byte() % 18);
  packing.flag_bits = int(choices.byte() % 10);
  packing.x = {-double(choices.byte()), std::ldexp(1, int(choices.byte() << 2))};
  packing.y = {std::ldexp(-1, int(choices.byte() << 2)), 100};
  packing.components.assign(choices.byte() % 5, {0, 1});
  return packing;
}

void require_color(const Components& color, const Packing& packing) {
  require(color.size() == packing.components.size(), "a colour has all its components");
  for (const double component : color)
    require(component >= 0 && component <= 1, "a component lies in its range");
}

void require_place(glm::dvec2 place, const Packing& packing) {
  require(place.x >= packing.x[0] && place.x <= packing.x[1] && place.y >= packing.y[0] &&
              place.y <= packing.y[1],
          "a point lies in its range");
}

void check_patches(std::string_view data, const Packing& packing, PatchKind kind) {
  const ShadingPatches all = read_patches(data, packing, kind, most);
  for (const ShadingPatch& patch : all.patches) {
    for (const Components& color : patch.colors) require_color(color, packing);
    for (const glm::dvec2 point : patch.outer) require_place(point, packing);
  }
  const ShadingPatches some = read_patches(data.substr(0, data.size() / 2), packing, kind, most);
  require(some.patches.size() <= all.patches.size(), "less data have no more patches");
  if (kind == PatchKind::tensor)
    require(std::ranges::equal(some.patches, std::span(all.patches).first(some.patches.size())),
            "what lies before damage is read");
}

void check_triangles(std::string_view data, const Packing& packing) {
  for (const ShadingTriangle& triangle : read_triangles(data, packing, most).triangles)
    for (const ShadingVertex& vertex : triangle) {
      require_color(vertex.color, packing);
      require_place(vertex.place, packing);
    }
}

}  // namespace

/// The packing, and then the data of the shading.
void check(std::string_view input) {
  Choices choices(input.substr(0, header));
  const unsigned kind = choices.byte() % 4;
  const Packing packing = packing_of(choices);
  try {
    gradmesh::check(packing, kind != 3);
  } catch (const InputError&) {
    return;
  }
  const std::string_view data = input.substr(std::min(header, input.size()));
  if (kind < 2) return check_patches(data, packing, kind ? PatchKind::tensor : PatchKind::coons);
  if (kind == 2) return check_triangles(data, packing);
  const ShadingLattice lattice = read_lattice(data, packing, 3, most);
  require(lattice.vertices.size() % 3 == 0, "rows are whole");
}

}  // namespace gradmesh::fuzz
