#include "formats/pdf/page/read_shading.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "base/clamped_int.h"
#include "base/error.h"
#include "base/limits.h"
#include "formats/pdf/objects/dictionary.h"
#include "formats/pdf/objects/stream_bytes.h"
#include "formats/pdf/page/read_color_space.h"
#include "formats/pdf/page/read_function.h"
#include "formats/pdf/shading/read_triangles.h"
#include "formats/pdf/shading/triangle_fan.h"

namespace gradmesh {
namespace {

int integer(QPDFObjectHandle dictionary, const char* key) {
  constexpr int most = 1 << 20;
  return clamped_int(number_of(value_of(dictionary, key)).value_or(0), 0, most);
}

ShadingColors colors_of(QPDFObjectHandle shading, const NamedSpaces* spaces) {
  ColorSpace space = read_color_space(value_of(shading, "/ColorSpace"),
                                      spaces ? spaces->dictionary : QPDFObjectHandle::newNull());
  QPDFObjectHandle function = value_of(shading, "/Function");
  if (function.isNull()) return {std::move(space), {}};
  return {std::move(space), read_function(function)};
}

Packing packing_of(QPDFObjectHandle shading, std::size_t components) {
  Packing packing;
  packing.coordinate_bits = integer(shading, "/BitsPerCoordinate");
  packing.component_bits = integer(shading, "/BitsPerComponent");
  packing.flag_bits = integer(shading, "/BitsPerFlag");
  const std::vector<double> decode = numbers_of(value_of(shading, "/Decode"));
  if (decode.size() >= 4 + 2 * components) {
    packing.x = {decode[0], decode[1]};
    packing.y = {decode[2], decode[3]};
    for (std::size_t n = 4; n < 4 + 2 * components; n += 2)
      packing.components.push_back({decode[n], decode[n + 1]});
  }
  return packing;
}

ShadingPatch straight_patch_of(const std::array<const ShadingVertex*, 4>& corners) {
  std::array<glm::dvec2, 4> places{};
  std::array<Components, 4> colors;
  for (std::size_t k = 0; k < 4; ++k) {
    places[k] = corners[k]->place;
    colors[k] = corners[k]->color;
  }
  return straight_patch(places, colors);
}

/// Returns triangles, of which four that are the cell of a lattice are one patch where that is the
/// same.
ShadingPatches triangles_of(std::string_view data, const Packing& packing, std::size_t most) {
  // Four of them may be one patch.
  const ShadingTriangles read = read_triangles(data, packing, 4 * most);
  const std::span<const ShadingTriangle> all(read.triangles);
  ShadingPatches patches{{}, 0, read.is_damaged};
  for (std::size_t n = 0; n < all.size();) {
    const auto fan = n + 4 <= all.size() ? fan_of(all.subspan(n).first<4>()) : std::nullopt;
    if (fan && is_bilinear(*fan, packing.components)) {
      const auto& corners = fan->corners;
      patches.patches.push_back(
          straight_patch_of({&corners[0], &corners[1], &corners[2], &corners[3]}));
      n += 4;
      continue;
    }
    const ShadingTriangle& t = all[n++];
    patches.patches.push_back(straight_patch_of({&t[0], &t[1], &t[2], &t[2]}));
  }
  patches.count = patches.patches.size() + read.count - all.size();
  return patches;
}

/// Returns true if two triangles with these corners have the colours, and cover what is covered, of
/// one bilinear patch: but for 4 levels of 255 of what a component may be.
bool is_one_patch(const std::array<const ShadingVertex*, 4>& corners, const Packing& packing) {
  const auto bend = [&](auto of) { return of(0) - of(1) + of(2) - of(3); };
  const glm::dvec2 bent = bend([&](std::size_t k) { return corners[k]->place; });
  const glm::dvec2 across = corners[2]->place - corners[0]->place;
  if (glm::length(bent) > 0.01 * glm::length(across)) return false;
  for (std::size_t n = 0; n < packing.components.size(); ++n) {
    const auto [low, high] = packing.components[n];
    const double differs = bend([&](std::size_t k) { return corners[k]->color[n]; });
    if (std::abs(differs) > 4.0 / 255 * std::abs(high - low)) return false;
  }
  return true;
}

/// Returns the triangles of a lattice, two for each of its cells (ISO 32000-1, 8.7.4.5.6); one
/// patch where that is the same.
ShadingPatches cells_of(std::string_view data, const Packing& packing, std::size_t columns,
                        std::size_t most) {
  if (columns < 2) throw InputError("a row of its lattice has less than two points");
  const ShadingLattice read = read_lattice(data, packing, columns, most);
  ShadingPatches patches{{}, 0, read.is_damaged};
  const std::size_t rows = read.vertices.size() / columns;
  for (std::size_t i = 0; i + 1 < rows; ++i)
    for (std::size_t j = 0; j + 1 < columns; ++j) {
      const ShadingVertex* const above = &read.vertices[i * columns + j];
      const ShadingVertex* const below = above + columns;
      if (is_one_patch({above, above + 1, below + 1, below}, packing)) {
        patches.patches.push_back(straight_patch_of({above, above + 1, below + 1, below}));
        continue;
      }
      patches.patches.push_back(straight_patch_of({above, above + 1, below, below}));
      patches.patches.push_back(straight_patch_of({above + 1, below + 1, below, below}));
    }
  patches.count = patches.patches.size() + 2 * (read.rows - rows) * (columns - 1);
  return patches;
}

ShadingPatches patches_of(int type, std::string_view data, const Packing& packing,
                          std::size_t columns) {
  const std::uint64_t most = limits().patches;
  check(packing, type != 5);
  ShadingPatches read = [&] {
    if (type == 4) return triangles_of(data, packing, most + 1);
    if (type == 5) return cells_of(data, packing, columns, 2 * (most + 2));
    return read_patches(data, packing, type == 6 ? PatchKind::coons : PatchKind::tensor, most + 1);
  }();
  if (read.count > most) throw TooManyPatches(read.count);
  return read;
}

/// Maps a patch to the page. Returns false if it has no size there, or lies beyond any page.
bool put_on_page(ShadingPatch& patch, const Affine& to_page) {
  constexpr double farthest = 1e6;
  Box box;
  const auto put = [&](glm::dvec2& point) {
    point = to_page.point(point);
    box.add(point);
    return std::abs(point.x) <= farthest && std::abs(point.y) <= farthest;
  };
  return std::ranges::all_of(patch.outer, put) && std::ranges::all_of(patch.inner, put) &&
         std::max(box.size().x, box.size().y) > 0;
}

}  // namespace

ShadingColors::ShadingColors(ColorSpace space, std::optional<Function> function)
    : space_(std::move(space)), function_(std::move(function)) {
  if (function_ && (function_->inputs() != 1 || function_->outputs() != space_.components()))
    throw InputError("the function of its colours does not fit its colour space");
}

glm::dvec3 ShadingColors::srgb(const Components& color) const {
  return space_.to_srgb(function_ ? (*function_)(color) : color);
}

TooManyPatches::TooManyPatches(std::size_t patches)
    : InputError("it has {0} patches, {1}", patches,
                 beyond_limit("patches", limits().patches, patches)),
      count(patches) {}

PageShading unplaced_shading(QPDFObjectHandle shading, const NamedSpaces* spaces) {
  PageShading read{integer(shading, "/ShadingType"), colors_of(shading, spaces), {}};
  if (!shading.isStream()) throw InputError("it has no patches");
  const StreamBytes data = stream_bytes(shading);
  ShadingPatches patches =
      patches_of(read.type, data.bytes, packing_of(shading, read.colors.count()),
                 std::size_t(integer(shading, "/VerticesPerRow")));
  read.is_damaged = data.is_damaged || patches.is_damaged;
  read.patches = std::move(patches.patches);
  return read;
}

PageShading placed(PageShading shading, const Affine& to_page) {
  const std::size_t left_out = std::erase_if(
      shading.patches, [&](ShadingPatch& patch) { return !put_on_page(patch, to_page); });
  shading.is_damaged = shading.is_damaged || left_out > 0;
  return shading;
}

PageShading read_shading(const PaintedShading& painted) {
  return placed(unplaced_shading(painted.shading, painted.spaces.get()), painted.to_page);
}

std::shared_ptr<const PageShading> KeptShadings::read(const PaintedShading& painted) {
  const std::pair key(painted.shading.getObjGen(),
                      painted.spaces ? painted.spaces->text : std::string());
  auto found = kept_.find(key);
  // What is no object of its own has no number by which it could be known again.
  if (found == kept_.end() || !painted.shading.isIndirect()) {
    Kept now = read_now(painted);
    const std::size_t count = now.shading ? now.shading->patches.size() : 0;
    // A few of the largest shadings take no memory to speak of.
    if (patches_ + count > 4 * limits().patches) {
      kept_.clear();
      patches_ = 0;
    }
    patches_ += count;
    found = kept_.insert_or_assign(key, std::move(now)).first;
  }
  if (found->second.error) std::rethrow_exception(found->second.error);
  return found->second.shading;
}

KeptShadings::Kept KeptShadings::read_now(const PaintedShading& painted) {
  try {
    return {std::make_shared<const PageShading>(
                unplaced_shading(painted.shading, painted.spaces.get())),
            nullptr};
  } catch (const InputError&) {
    return {nullptr, std::current_exception()};
  }
}

}  // namespace gradmesh
