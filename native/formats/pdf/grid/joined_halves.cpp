#include "formats/pdf/grid/joined_halves.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gradmesh {
namespace {

using Row = std::array<glm::dvec2, 4>;
using Net = std::array<Row, 4>;

bool is_close(glm::dvec2 a, glm::dvec2 b, double tolerance) {
  return std::abs(a.x - b.x) <= tolerance && std::abs(a.y - b.y) <= tolerance;
}

/// Returns the curve of which two are about the halves: the closest to their points, which are off
/// by what rounds them, and where they begin and end.
Row closest_whole(const Row& a, const Row& b) {
  const glm::dvec2 from = a[0], to = b[3], middle = 0.5 * (a[3] + b[0]);
  // By de Casteljau's rule each of the points between is a sum of the four control points; of the
  // two that are not known these are the normal equations, with `sum` and `difference` of them.
  const std::array<glm::dvec2, 5> known{a[1] - 0.5 * from, a[2] - 0.25 * from,
                                        middle - 0.125 * (from + to), b[1] - 0.25 * to,
                                        b[2] - 0.5 * to};
  constexpr std::array<double, 5> first{0.5, 0.5, 0.375, 0.25, 0}, second{0, 0.25, 0.375, 0.5, 0.5};
  glm::dvec2 by_first(0.0), by_second(0.0);
  double square = 0, product = 0;
  for (std::size_t n = 0; n < known.size(); ++n) {
    by_first += first[n] * known[n];
    by_second += second[n] * known[n];
    square += first[n] * first[n];
    product += first[n] * second[n];
  }
  const glm::dvec2 sum = (by_first + by_second) / (square + product);
  const glm::dvec2 difference = (by_first - by_second) / (square - product);
  return {from, 0.5 * (sum + difference), 0.5 * (sum - difference), to};
}

/// Returns the curve of which two are the halves, if they are.
std::optional<Row> whole_curve(const Row& a, const Row& b, double tolerance) {
  if (!is_close(a[3], b[0], tolerance)) return {};
  const Row whole = closest_whole(a, b);
  const glm::dvec2 middle = 0.5 * (whole[1] + whole[2]);
  const glm::dvec2 a1 = 0.5 * (whole[0] + whole[1]), b2 = 0.5 * (whole[2] + whole[3]);
  const glm::dvec2 a2 = 0.5 * (a1 + middle), b1 = 0.5 * (b2 + middle);
  const bool is_one = is_close(a[1], a1, tolerance) && is_close(a[2], a2, tolerance) &&
                      is_close(a[3], 0.5 * (a2 + b1), tolerance) && is_close(b[1], b1, tolerance) &&
                      is_close(b[2], b2, tolerance);
  return is_one ? std::optional(whole) : std::nullopt;
}

bool is_close(const Components& a, const Components& b) {
  constexpr double hardly = 2.5 / 255;
  return std::ranges::equal(a, b, [](double x, double y) { return std::abs(x - y) <= hardly; });
}

/// Joins patches that meet at side 1 of `a` and side 3 of `b`.
std::optional<ShadingPatch> joined_along(const ShadingPatch& a, const ShadingPatch& b,
                                         double tolerance) {
  if (!is_close(a.colors[1], b.colors[0]) || !is_close(a.colors[2], b.colors[3])) return {};
  const Net left = a.net(), right = b.net();
  Net whole;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto row = whole_curve(left[i], right[i], tolerance);
    if (!row) return {};
    whole[i] = *row;
  }
  ShadingPatch patch;
  patch.set_net(whole);
  patch.colors = {a.colors[0], b.colors[1], b.colors[2], a.colors[3]};
  return patch;
}

}  // namespace

std::optional<ShadingPatch> joined(const ShadingPatch& a, const ShadingPatch& b, double tolerance) {
  for (std::size_t k = 0; k < 4; ++k) {
    const ShadingPatch first = a.turned(k);
    const glm::dvec2 from = first.outer[3], to = first.outer[6];
    for (std::size_t n = 0; n < 4; ++n)
      for (const bool is_mirrored : {false, true}) {
        const ShadingPatch second = is_mirrored ? b.turned(n).mirrored() : b.turned(n);
        if (!is_close(second.outer[0], from, tolerance) ||
            !is_close(second.outer[9], to, tolerance))
          continue;
        if (auto whole = joined_along(first, second, tolerance)) return whole;
      }
  }
  return {};
}

std::vector<ShadingPatch> without_halving(const std::vector<ShadingPatch>& patches) {
  // Points lie on 1/2048 of one. Each level adds less than half of the error of what follows from
  // them; what is beyond the largest tolerance only looks like halves.
  constexpr double first_tolerance = 0.002, growth = 1.5, largest_tolerance = 0.015;
  struct Part {
    ShadingPatch patch;
    double tolerance;
  };
  std::vector<Part> stack;
  for (const ShadingPatch& patch : patches) {
    stack.push_back({patch, first_tolerance});
    while (stack.size() > 1) {
      const Part &a = stack[stack.size() - 2], &b = stack.back();
      const double tolerance = std::max(a.tolerance, b.tolerance);
      auto whole = joined(a.patch, b.patch, tolerance);
      if (!whole) break;
      stack.pop_back();
      stack.back() = {*std::move(whole), std::min(growth * tolerance, largest_tolerance)};
    }
  }
  std::vector<ShadingPatch> wholes;
  for (Part& part : stack) wholes.push_back(std::move(part.patch));
  return wholes;
}

}  // namespace gradmesh
