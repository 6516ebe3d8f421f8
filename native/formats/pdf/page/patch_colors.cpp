#include "formats/pdf/page/patch_colors.h"

#include <algorithm>
#include <glm/common.hpp>
#include <iterator>
#include <utility>

#include "base/limits.h"
#include "formats/pdf/grid/joined_curves.h"

namespace gradmesh {
namespace {

constexpr int most_halvings = 5;
/// What an eye hardly sees. Patches of Adobe's programs, which halve them themselves, are as close.
constexpr double allowed_difference = 4.0 / 255;

/// A corner of a part: what blends linearly between corners, and what is seen there.
struct CornerPaint {
  Components components;
  double opacity = 1;
  glm::dvec3 srgb{0.0};
};

struct PatchPart {
  PatchAround<CornerPaint> patch;
  bool is_done = false;
};

/// The directions in which a patch is halved: along sides 0 and 2, along sides 1 and 3.
struct Halving {
  bool along_even = false, along_odd = false;
};

Components blend(const Components& a, const Components& b, double share) {
  Components blended(a.size());
  for (std::size_t n = 0; n < a.size(); ++n) blended[n] = (1 - share) * a[n] + share * b[n];
  return blended;
}

double difference(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 apart = glm::abs(a - b);
  return std::max({apart.r, apart.g, apart.b});
}

/// Colours of a patch at a lattice of its parameters.
class ColorLattice {
 public:
  ColorLattice(const PatchAround<CornerPaint>& patch, const ShadingColors& colors);

  /// Returns the largest difference from a blend of the four corners.
  double from_corners() const;
  /// Return the largest difference of the even sides, and that of the odd ones, from a blend of
  /// their ends.
  double of_even_sides() const { return std::max(of_row(0), of_row(last)); }
  double of_odd_sides() const { return std::max(of_column(0), of_column(last)); }
  /// Return the same for all lines beside these sides.
  double of_rows() const { return of_lines(&ColorLattice::of_row); }
  double of_columns() const { return of_lines(&ColorLattice::of_column); }

 private:
  static constexpr std::size_t size = 5, last = size - 1;
  /// Not in quarters: stripes of a function, of which the colours at all quarters are the same, are
  /// more likely than others that are missed.
  static constexpr std::array<double, size> shares{0, 0.21, 0.5, 0.79, 1};
  static double share(std::size_t n) { return shares[n]; }

  double of_row(std::size_t i) const;
  double of_column(std::size_t j) const;
  double of_lines(double (ColorLattice::*of_line)(std::size_t) const) const;

  /// Rows run along side 0, columns along side 1.
  std::array<std::array<glm::dvec3, size>, size> at_{};
};

ColorLattice::ColorLattice(const PatchAround<CornerPaint>& patch, const ShadingColors& colors) {
  const auto& corners = patch.colors;
  for (std::size_t i = 0; i < size; ++i) {
    const Components left = blend(corners[0].components, corners[3].components, share(i));
    const Components right = blend(corners[1].components, corners[2].components, share(i));
    for (std::size_t j = 0; j < size; ++j) at_[i][j] = colors.srgb(blend(left, right, share(j)));
  }
}

double ColorLattice::from_corners() const {
  double largest = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const glm::dvec3 left = glm::mix(at_[0][0], at_[last][0], share(i));
    const glm::dvec3 right = glm::mix(at_[0][last], at_[last][last], share(i));
    for (std::size_t j = 0; j < size; ++j)
      largest = std::max(largest, difference(at_[i][j], glm::mix(left, right, share(j))));
  }
  return largest;
}

double ColorLattice::of_row(std::size_t i) const {
  double largest = 0;
  for (std::size_t j = 0; j < size; ++j)
    largest = std::max(largest, difference(at_[i][j], glm::mix(at_[i][0], at_[i][last], share(j))));
  return largest;
}

double ColorLattice::of_column(std::size_t j) const {
  double largest = 0;
  for (std::size_t i = 0; i < size; ++i)
    largest = std::max(largest, difference(at_[i][j], glm::mix(at_[0][j], at_[last][j], share(i))));
  return largest;
}

double ColorLattice::of_lines(double (ColorLattice::*of_line)(std::size_t) const) const {
  double largest = 0;
  for (std::size_t n = 0; n < size; ++n) largest = std::max(largest, (this->*of_line)(n));
  return largest;
}

/// Returns where a patch has to be halved, if at all. Of a side that two patches share both find
/// the same.
Halving halving_of(const PatchAround<CornerPaint>& patch, const ShadingColors& colors) {
  const ColorLattice lattice(patch, colors);
  if (lattice.from_corners() <= allowed_difference) return {};
  const Halving by_sides{lattice.of_even_sides() > allowed_difference,
                         lattice.of_odd_sides() > allowed_difference};
  if (by_sides.along_even || by_sides.along_odd) return by_sides;
  const double along_even = lattice.of_rows(), along_odd = lattice.of_columns();
  return {along_even >= along_odd, along_odd >= along_even};
}

CornerPaint between(const CornerPaint& a, const CornerPaint& b, const ShadingColors& colors) {
  CornerPaint middle{blend(a.components, b.components, 0.5), 0.5 * (a.opacity + b.opacity)};
  middle.srgb = colors.srgb(middle.components);
  return middle;
}

/// The halves of a patch beside its side 3 and its side 1.
std::array<PatchPart, 2> halves_of(const PatchPart& part, const ShadingColors& colors) {
  const auto net = part.patch.net();
  std::array<PatchPart, 2> halves;
  for (std::size_t which = 0; which < 2; ++which) {
    auto half = net;
    for (auto& row : half) row = part_of(row, 0.5 * double(which), 0.5 * double(which + 1));
    halves[which].patch.set_net(half);
  }
  const auto& corners = part.patch.colors;
  const CornerPaint even = between(corners[0], corners[1], colors);
  const CornerPaint odd = between(corners[3], corners[2], colors);
  halves[0].patch.colors = {corners[0], even, odd, corners[3]};
  halves[1].patch.colors = {even, corners[1], corners[2], odd};
  return halves;
}

std::vector<PatchPart> parts_of(const PatchPart& whole, const Halving& halving,
                                const ShadingColors& colors) {
  std::vector<PatchPart> parts{whole};
  const auto halve = [&](std::size_t turns) {
    std::vector<PatchPart> halved;
    for (const PatchPart& part : parts)
      for (PatchPart& half : halves_of({part.patch.turned(turns)}, colors))
        halved.push_back({half.patch.turned((4 - turns) % 4)});
    parts = std::move(halved);
  };
  if (halving.along_odd) halve(1);
  if (halving.along_even) halve(0);
  return parts;
}

/// Halves all parts that are not close, as long as there are no more than `most` of them. Returns
/// false if none was.
bool halve_once(std::vector<PatchPart>& parts, const ShadingColors& colors, std::size_t most) {
  std::vector<PatchPart> next;
  bool is_any_halved = false;
  for (std::size_t n = 0; n < parts.size(); ++n) {
    PatchPart& part = parts[n];
    const std::size_t others = next.size() + parts.size() - n - 1;
    const bool may_be_halved = !part.is_done && others + 2 <= most;
    const Halving halving = may_be_halved ? halving_of(part.patch, colors) : Halving();
    const std::size_t count = (halving.along_even ? 2U : 1U) * (halving.along_odd ? 2U : 1U);
    if (count == 1 || others + count > most) {
      part.is_done = count == 1;
      next.push_back(std::move(part));
      continue;
    }
    is_any_halved = true;
    std::ranges::move(parts_of(part, halving, colors), std::back_inserter(next));
  }
  parts = std::move(next);
  return is_any_halved;
}

}  // namespace

std::vector<PagePatch> corners_in_srgb(const std::vector<ShadingPatch>& patches,
                                       const ShadingColors& colors) {
  std::vector<PagePatch> all;
  for (const ShadingPatch& patch : patches) {
    PagePatch& made = all.emplace_back();
    made.outer = patch.outer;
    made.inner = patch.inner;
    for (std::size_t k = 0; k < 4; ++k)
      made.colors[k] = glm::dvec4(colors.srgb(patch.colors[k]), 1);
  }
  return all;
}

std::vector<PagePatch> in_srgb(const std::vector<ShadingPatch>& patches,
                               const ShadingColors& colors,
                               const std::vector<CornerOpacities>& opacities) {
  std::vector<PatchPart> parts;
  for (std::size_t n = 0; n < patches.size(); ++n) {
    const ShadingPatch& patch = patches[n];
    PatchPart& part = parts.emplace_back();
    part.patch.outer = patch.outer;
    part.patch.inner = patch.inner;
    for (std::size_t k = 0; k < 4; ++k)
      part.patch.colors[k] = {patch.colors[k], n < opacities.size() ? opacities[n][k] : 1,
                              colors.srgb(patch.colors[k])};
  }
  // All patches are halved once before one is twice, so that a limit leaves none of them out.
  const std::size_t most = std::max<std::size_t>(patches.size(), limits().patches);
  for (int n = 0; n < most_halvings; ++n)
    if (!halve_once(parts, colors, most)) break;
  std::vector<PagePatch> all;
  for (const PatchPart& part : parts) {
    PagePatch& made = all.emplace_back();
    made.outer = part.patch.outer;
    made.inner = part.patch.inner;
    for (std::size_t k = 0; k < 4; ++k)
      made.colors[k] = glm::dvec4(part.patch.colors[k].srgb, part.patch.colors[k].opacity);
  }
  return all;
}

}  // namespace gradmesh
