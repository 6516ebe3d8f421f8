#include "formats/pdf/shading/packing.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "base/error.h"

namespace gradmesh {
namespace {

bool is_one_of(int bits, std::initializer_list<int> allowed) {
  return std::ranges::find(allowed, bits) != allowed.end();
}

bool is_finite(const Packing::Range& range) {
  return std::isfinite(range[0]) && std::isfinite(range[1]);
}

}  // namespace

void check(const Packing& packing, bool has_flags) {
  if (!is_one_of(packing.coordinate_bits, {1, 2, 4, 8, 12, 16, 24, 32}))
    throw InputError("a shading's coordinates have {0} bits", packing.coordinate_bits);
  if (!is_one_of(packing.component_bits, {1, 2, 4, 8, 12, 16}))
    throw InputError("the colours of a shading have {0} bits", packing.component_bits);
  if (has_flags && !is_one_of(packing.flag_bits, {2, 4, 8}))
    throw InputError("a shading's flags have {0} bits", packing.flag_bits);
  if (packing.components.empty() || !is_finite(packing.x) || !is_finite(packing.y) ||
      !std::ranges::all_of(packing.components, is_finite))
    throw InputError("a shading does not say what its numbers mean");
}

std::optional<int> ShadingReader::flag() {
  const auto raw = bits_.read(packing_.flag_bits);
  if (!raw) return {};
  return int(*raw & 3);
}

std::optional<glm::dvec2> ShadingReader::point() {
  const auto x = number(packing_.coordinate_bits, packing_.x);
  const auto y = x ? number(packing_.coordinate_bits, packing_.y) : std::nullopt;
  if (!y) return {};
  return glm::dvec2(*x, *y);
}

std::optional<Components> ShadingReader::color() {
  Components color;
  for (const Packing::Range& range : packing_.components) {
    const auto component = number(packing_.component_bits, range);
    if (!component) return {};
    color.push_back(*component);
  }
  return color;
}

std::optional<double> ShadingReader::number(int bits, const Packing::Range& range) {
  const auto raw = bits_.read(bits);
  if (!raw) return {};
  const double share = double(*raw) / double((std::uint64_t(1) << bits) - 1);
  // It neither leaves the range nor overflows where that is the largest.
  return std::lerp(range[0], range[1], share);
}

}  // namespace gradmesh
