#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "formats/pdf/grid/page_patch.h"

namespace gradmesh {

/// A bent sheet of patches whose sides are curves that neighbours share; corner (i, j) has a colour
/// of its own.
class Sheet {
 public:
  Sheet(int rows, int columns) : rows_(rows), columns_(columns) {}

  PagePatch patch(int row, int column) const {
    PagePatch patch;
    // Twelve points around, in thirds of a patch: u down, v to the right.
    static constexpr int around[12][2] = {{0, 0}, {0, 1}, {0, 2}, {0, 3}, {1, 3}, {2, 3},
                                          {3, 3}, {3, 2}, {3, 1}, {3, 0}, {2, 0}, {1, 0}};
    static constexpr int inside[4][2] = {{1, 1}, {1, 2}, {2, 2}, {2, 1}};
    for (std::size_t n = 0; n < 12; ++n)
      patch.outer[n] = place(3 * row + around[n][0], 3 * column + around[n][1]);
    for (std::size_t k = 0; k < 4; ++k) {
      patch.inner[k] = place(3 * row + inside[k][0], 3 * column + inside[k][1]);
      const int i = row + (k > 1), j = column + (k == 1 || k == 2);
      patch.colors[k] = {0.05 * i, 0.05 * j, 0.5, 1};
    }
    return patch;
  }

  std::vector<PagePatch> patches() const {
    std::vector<PagePatch> all;
    for (int i = 0; i < rows_; ++i)
      for (int j = 0; j < columns_; ++j) all.push_back(patch(i, j));
    return all;
  }

 private:
  static glm::dvec2 place(int thirds_down, int thirds_right) {
    const double y = thirds_down, x = thirds_right;
    return {10 * x + 2 * std::sin(0.7 * y), 10 * y + 3 * std::sin(0.5 * x)};
  }

  int rows_, columns_;
};

/// The parts of a patch beside side 3 and side 1, divided at a share of its sides 0 and 2.
inline std::array<PagePatch, 2> divided(const PagePatch& patch, double share) {
  std::array<std::array<std::array<glm::dvec2, 4>, 4>, 2> nets;
  const auto net = patch.net();
  for (std::size_t i = 0; i < 4; ++i) {
    const auto at = [share](glm::dvec2 a, glm::dvec2 b) { return a + share * (b - a); };
    const auto& row = net[i];
    const glm::dvec2 a = at(row[0], row[1]), b = at(row[1], row[2]), c = at(row[2], row[3]);
    const glm::dvec2 d = at(a, b), e = at(b, c), middle = at(d, e);
    nets[0][i] = {row[0], a, d, middle};
    nets[1][i] = {middle, e, c, row[3]};
  }
  std::array<PagePatch, 2> parts;
  for (std::size_t which = 0; which < 2; ++which) {
    parts[which].set_net(nets[which]);
    parts[which].colors = patch.colors;
    const auto between = [&](std::size_t k, std::size_t l) {
      return patch.colors[k] + share * (patch.colors[l] - patch.colors[k]);
    };
    parts[which].colors[which == 0 ? 1 : 0] = between(0, 1);
    parts[which].colors[which == 0 ? 2 : 3] = between(3, 2);
  }
  return parts;
}

/// A patch with straight sides between two corners across.
inline PagePatch rectangular_patch(glm::dvec2 from, glm::dvec2 to) {
  const glm::dvec2 corners[] = {from, {to.x, from.y}, to, {from.x, to.y}};
  PagePatch patch;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t n = 0; n < 3; ++n)
      patch.outer[3 * k + n] = corners[k] + double(n) / 3 * (corners[(k + 1) % 4] - corners[k]);
  return patch;
}

}  // namespace gradmesh
