#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "metric/metric.h"

namespace gradmesh {

/// Half-open range of columns.
struct Span {
  int begin = 0, end = 0;

  int width() const { return end - begin; }
  bool empty() const { return end <= begin; }
};

/// A few consecutive rows of the map and the columns to score in each of them.
struct Strip {
  Window box;                  ///< Holds all the rows' columns; inside the frame.
  std::span<const Span> rows;  ///< From box.y0 to box.y1; may be empty.
};

/// A metric whose value at a pixel depends on the pixels within `reach` of it only, and is 0
/// where none of these differs. It scores only the pixels near a difference; in strips, which
/// run in parallel and are low enough for a strip's planes to stay in the cache.
class LocalMetric : public Metric {
 public:
  void fill_map(const Image& test, Window window, Plane& map) const final;
  int reach() const final { return reach_; }

 protected:
  LocalMetric(Image reference, int reach) : reference_(std::move(reference)), reach_(reach) {}

  virtual void score(const Image& test, const Strip& strip, Plane& map) const = 0;
  const Image& reference() const { return reference_; }

 private:
  Image reference_;
  int reach_;
};

/// Calls `body(strip)` in parallel for strips that together cover `rows`, the spans of
/// consecutive rows from `y0` on; leaves out strips without any pixel.
void for_each_strip(int y0, std::span<const Span> rows,
                    const std::function<void(const Strip&)>& body);

/// For every row of `window`, the columns in which a pixel may lie within `reach` of a pixel
/// that differs between two images of the same size.
std::vector<Span> columns_near_differences(const Image& a, const Image& b, Window window,
                                           int reach);

}  // namespace gradmesh
