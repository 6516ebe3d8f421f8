#include "raster/hidden.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/clamped_int.h"
#include "geom/crossings.h"

namespace gradmesh {
namespace {

constexpr int lines_a_row = 4;

/// Marks the pixels of a row that the line meets inside the polygons.
void mark(const std::vector<Crossing>& line, FillRule rule, std::span<char> seen) {
  const auto width = int(seen.size());
  int winding = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    winding += line[i].winding;
    if (!is_inside(winding, rule)) continue;
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
    const auto lines =
        crossings(mapped(filled.outline, to_pixels), lines_a_row, 0, seen.height * lines_a_row + 1);
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
