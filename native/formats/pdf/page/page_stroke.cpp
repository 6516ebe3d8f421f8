#include "formats/pdf/page/page_stroke.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gradmesh {
namespace {

/// Returns what a map does to a circle but for its size: the symmetric map of area 1 that makes the
/// same ellipse of it. The identity where it stays a circle, or has no area.
Affine pen_of(const Affine& map) {
  // The ellipse of A is that of the root of A A^T, which is symmetric.
  const glm::dmat2 square = map.linear * glm::transpose(map.linear);
  const double size = std::abs(map.determinant()), trace = square[0].x + square[1].y;
  // Farther than this from a circle it is a line, and its inverse has lost its digits.
  constexpr double rounding = 1e-6, thinnest = 1e-6;
  if (!(size > thinnest * trace) || trace < 2 * size * (1 + rounding)) return {};
  const double scale = 1 / std::sqrt(size * (trace + 2 * size));
  return {(square + glm::dmat2(size)) * scale, glm::dvec2(0.0)};
}

}  // namespace

PageStroke page_stroke(PagePath path, LineStyle line, const Affine& to_page) {
  const double scale = std::sqrt(std::abs(to_page.determinant()));
  const auto put = [&](double& length) {
    // What is longer than any page is wide looks the same, and is a number that SVG can hold.
    constexpr double longest = 1e6;
    length = std::clamp(scale * length, -longest, longest);
  };
  put(line.width);
  std::ranges::for_each(line.dashes, put);
  put(line.dash_phase);
  // A line as thin as can be seen is as thin in all directions.
  const Affine pen = line.width > 0 ? pen_of(to_page) : Affine();
  return {std::move(path), std::move(line), pen};
}

}  // namespace gradmesh
