#include "raster/hidden.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/clamped_int.h"

namespace gradmesh {
namespace {

constexpr int lines_a_row = 4;

/// Where a line of constant y enters or leaves polygons.
struct Crossing {
  double x;
  /// 1 where the polygon's side runs down, -1 where it runs up.
  int winding;
};

/// Returns the crossings of all lines y = k / lines_a_row, 0 <= k < `lines`, unsorted. A side owns
/// its upper end and not its lower one, so that corners count once.
std::vector<std::vector<Crossing>> crossings(const Outline& outline, const Affine& to_pixels,
                                             int lines) {
  std::vector<std::vector<Crossing>> result{std::size_t(lines)};
  for (const std::vector<glm::dvec2>& polygon : outline)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      glm::dvec2 a = to_pixels.point(polygon[i]);
      glm::dvec2 b = to_pixels.point(polygon[(i + 1) % polygon.size()]);
      const int winding = a.y < b.y ? 1 : -1;
      if (winding < 0) std::swap(a, b);
      const int first = clamped_int(std::ceil(a.y * lines_a_row), 0, lines);
      const int end = clamped_int(std::ceil(b.y * lines_a_row), 0, lines);
      for (int k = first; k < end; ++k) {
        const double t = (double(k) / lines_a_row - a.y) / (b.y - a.y);
        result[std::size_t(k)].push_back({std::lerp(a.x, b.x, t), winding});
      }
    }
  return result;
}

/// Marks the pixels of a row that the line meets inside the polygons.
void mark(std::vector<Crossing> line, FillRule rule, std::span<char> seen) {
  std::ranges::sort(line, {}, &Crossing::x);
  const auto width = int(seen.size());
  int winding = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    winding += line[i].winding;
    const bool inside = rule == FillRule::evenodd ? winding % 2 != 0 : winding != 0;
    if (!inside) continue;
    const int first = clamped_int(std::floor(line[i].x), 0, width);
    const int end = clamped_int(std::ceil(line[i + 1].x), 0, width);
    if (first < end) std::fill(seen.begin() + first, seen.begin() + end, true);
  }
}

/// Unmarks the pixels of which no part lies inside any of the outlines.
void hide_beyond(const std::vector<FilledOutline>& outlines, const Affine& to_pixels,
                 Raster<char, 1>& seen) {
  Raster<char, 1> inside(seen.window(), false);
  for (const FilledOutline& filled : outlines) {
    const auto lines = crossings(filled.outline, to_pixels, seen.height * lines_a_row + 1);
    for (int y = 0; y < seen.height; ++y)
      for (int k = 0; k <= lines_a_row; ++k)
        mark(lines[std::size_t(y) * lines_a_row + std::size_t(k)], filled.rule,
             {inside.at(0, y), std::size_t(seen.width)});
  }
  for (std::size_t i = 0; i < seen.samples.size(); ++i)
    seen.samples[i] = seen.samples[i] && inside.samples[i];
}

std::vector<HiddenPixels::Run> unmarked(std::span<const char> seen) {
  std::vector<HiddenPixels::Run> runs;
  for (auto at = seen.begin(); at != seen.end();) {
    const auto begin = std::find(at, seen.end(), false);
    at = std::find(begin, seen.end(), true);
    if (begin != at) runs.push_back({int(begin - seen.begin()), int(at - seen.begin())});
  }
  return runs;
}

}  // namespace

HiddenPixels::HiddenPixels(const VisibleArea& area, const Frame& frame) {
  Raster<char, 1> seen(frame.width, frame.height, true);
  for (const std::vector<FilledOutline>& set : area.sets) hide_beyond(set, frame.to_pixels, seen);
  for (int y = 0; y < frame.height; ++y)
    rows_.push_back(unmarked({seen.at(0, y), std::size_t(frame.width)}));
}

bool HiddenPixels::contains(int x, int y) const {
  if (y < 0 || y >= int(rows_.size())) return false;
  return std::ranges::any_of(row(y), [x](Run run) { return run.begin <= x && x < run.end; });
}

void HiddenPixels::hide(Window window, std::uint8_t ground, Painting& painting) const {
  window = window.clipped(painting.window());
  for (int y = window.y0; y < window.y1; ++y)
    for (const Run& run : row(y)) {
      const Window hidden = Window{run.begin, y, run.end, y + 1}.clipped(window);
      if (!hidden.empty()) painting.clear(hidden, ground);
    }
}

}  // namespace gradmesh
