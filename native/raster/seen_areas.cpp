#include "raster/seen_areas.h"

#include <algorithm>
#include <cmath>

#include "base/clamped_int.h"
#include "geom/crossings.h"

namespace gradmesh {
namespace {

/// Marks the pixels whose centres a line passes inside of polygons; `row` is the first one's place.
void mark_row(const std::vector<Crossing>& line, FillRule rule, int width, int index,
              std::vector<int>::iterator row) {
  int winding = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    winding += line[i].winding;
    if (!is_inside(winding, rule)) continue;
    const int begin = clamped_int(std::ceil(line[i].x - 0.5), 0, width);
    const int end = clamped_int(std::ceil(line[i + 1].x - 0.5), begin, width);
    std::fill(row + begin, row + end, index);
  }
}

}  // namespace

std::vector<int> seen_areas(const std::vector<FlatArea>& areas, const Frame& frame) {
  std::vector<int> seen(std::size_t(frame.width) * std::size_t(frame.height), -1);
  for (std::size_t n = 0; n < areas.size(); ++n) {
    // Only the rows that it meets: there may be thousands of small areas.
    const Outline outline = mapped(areas[n].area.outline, frame.to_pixels);
    const Box box = bounding_box(outline);
    if (box.empty()) continue;
    const int first = clamped_int(std::floor(box.low().y), 0, frame.height);
    const int end = clamped_int(std::ceil(box.high().y), first, frame.height);
    const auto lines = crossings(outline, 1, first + 0.5, end - first);
    for (int y = first; y < end; ++y)
      mark_row(lines[std::size_t(y - first)], areas[n].area.rule, frame.width, int(n),
               seen.begin() + std::ptrdiff_t(y) * frame.width);
  }
  return seen;
}

}  // namespace gradmesh
