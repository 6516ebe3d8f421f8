#include "metric/local_metric.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "base/parallel.h"

namespace gradmesh {
namespace {

constexpr std::size_t strip_height = 32;

Span united(Span a, Span b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

/// From the first to the last of the columns [x0, x1) of row y in which the images differ.
Span differing_columns(const Image& a, const Image& b, int y, int x0, int x1) {
  Span all;
  for (int c = 0; c < 3; ++c) {
    const std::uint8_t *row = a.at(x0, y, c), *end = row + (x1 - x0), *other = b.at(x0, y, c);
    const auto first = std::mismatch(row, end, other).first - row;
    if (row + first == end) continue;
    const auto last = std::mismatch(std::reverse_iterator(end), std::reverse_iterator(row),
                                    std::reverse_iterator(other + (end - row)))
                          .first.base() -
                      row;
    all = united(all, {x0 + int(first), x0 + int(last)});
  }
  return all;
}

}  // namespace

std::vector<Span> columns_near_differences(const Image& a, const Image& b, Window window,
                                           int reach) {
  const Window seen = window.grown(reach).clipped(a.window());
  std::vector<Span> near(window.height());
  for (int y = seen.y0; y < seen.y1; ++y) {
    const Span differing = differing_columns(a, b, y, seen.x0, seen.x1);
    if (differing.empty()) continue;
    const Span touched = {std::max(differing.begin - reach, window.x0),
                          std::min(differing.end + reach, window.x1)};
    const int first = std::max(y - reach, window.y0), last = std::min(y + reach, window.y1 - 1);
    for (int row = first; row <= last; ++row) {
      near[row - window.y0] = united(near[row - window.y0], touched);
    }
  }
  return near;
}

void for_each_strip(int y0, std::span<const Span> rows,
                    const std::function<void(const Strip&)>& body) {
  parallel_for((rows.size() + strip_height - 1) / strip_height, [&](std::size_t i) {
    const std::size_t first = i * strip_height;
    const auto part = rows.subspan(first, std::min(strip_height, rows.size() - first));
    Span all;
    for (const Span& row : part) all = united(all, row);
    if (all.empty()) return;
    const int top = y0 + int(first);
    body({{all.begin, top, all.end, top + int(part.size())}, part});
  });
}

void LocalMetric::fill_map(const Image& test, Window window, Plane& map) const {
  if (test.window() != reference_.window() || map.window() != reference_.window()) {
    throw std::invalid_argument("The images that a metric compares must have the same size.");
  }
  const Window inside = window.clipped(reference_.window());
  if (inside.empty()) return;
  for (int y = inside.y0; y < inside.y1; ++y)
    std::fill_n(map.at(inside.x0, y), inside.width(), 0.0F);
  const auto rows = columns_near_differences(reference_, test, inside, reach_);
  for_each_strip(inside.y0, rows, [&](const Strip& strip) { score(test, strip, map); });
}

}  // namespace gradmesh
