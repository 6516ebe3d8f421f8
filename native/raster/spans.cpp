#include "raster/spans.h"

#include <algorithm>

namespace gradmesh {
namespace {

constexpr std::int64_t unit = 1 << subpixel_bits, half = unit / 2;

/// A quotient that is rounded down, and the remainder.
struct Quotient {
  std::int64_t whole, left;

  Quotient(std::int64_t over, std::int64_t under) : whole(over / under), left(over % under) {
    if (left < 0) {
      left += under;
      --whole;
    }
  }
};

}  // namespace

bool SpanTracer::add_edge(SubpixelPoint a, SubpixelPoint b, bool ends, int y0, int y1) {
  const int first = std::max(first_pixel(a.y), y0), end = std::min(first_pixel(b.y), y1);
  if (first >= end) return true;
  const std::int64_t dx = b.x - a.x, dy = b.y - a.y, under = unit * dy;
  // The first pixel whose centre is not left of the edge: a quotient that is rounded up. From row
  // to row it grows by that of the slope.
  Quotient x((a.x - half) * dy + dx * (first * unit + half - a.y) + (under - 1), under);
  const Quotient slope(dx * unit, under);
  for (int y = first; y < end; ++y) {
    Row& row = rows_[std::size_t(y - y0)];
    if (row.count == most_crossings) return false;
    const std::int32_t crossing = std::int32_t(2 * x.whole) | std::int32_t(ends);
    int i = row.count++;
    for (; i > 0 && row.crossings[i - 1] > crossing; --i) row.crossings[i] = row.crossings[i - 1];
    row.crossings[i] = crossing;
    x.whole += slope.whole;
    x.left += slope.left;
    if (x.left >= under) {
      x.left -= under;
      ++x.whole;
    }
  }
  return true;
}

bool SpanTracer::trace(const std::vector<SubpixelPoint>& polygon, bool clockwise, int y0, int y1,
                       std::vector<Span>& spans) {
  spans.clear();
  if (y0 >= y1) return true;
  rows_.assign(std::size_t(y1 - y0), {});
  SubpixelPoint a = polygon.back();
  for (const SubpixelPoint b : polygon) {
    // Clockwise: edges that run upwards have the inside on their right.
    const bool down = b.y > a.y;
    if (!add_edge(down ? a : b, down ? b : a, down == clockwise, y0, y1)) return false;
    a = b;
  }
  for (int y = y0; y < y1; ++y) {
    const Row& row = rows_[std::size_t(y - y0)];
    for (int depth = 0, begin = 0, i = 0; i < row.count;) {
      const int x = row.crossings[i] >> 1, before = depth;
      for (; i < row.count && row.crossings[i] >> 1 == x; ++i)
        depth += row.crossings[i] & 1 ? -1 : 1;
      if (depth < 0 || depth > 1 || (i == row.count && depth != 0)) return false;
      if (before == 0) begin = x;
      if (before == 1 && depth == 0) spans.push_back({y, begin, x});
    }
  }
  return true;
}

}  // namespace gradmesh
