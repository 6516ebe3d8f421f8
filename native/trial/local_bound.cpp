#include "trial/local_bound.h"

#include <algorithm>

#include "metric/local_mean.h"

namespace gradmesh {
namespace {

/// A mesh is written with points and colours rounded, so that even an untouched window may differ a
/// little from the start.
constexpr double room_for_rounding = 1.01;

}  // namespace

LocalBound::LocalBound(double largest, const Plane& start) : largest_(largest) {
  if (room_for_rounding * largest_local_mean(start) <= largest) return;
  allowed_.reset(start.window());
  for_each_local_mean(start, [&](int x, int y, double mean) {
    *allowed_.at(x, y) = std::max(largest, room_for_rounding * mean);
  });
}

LocalBound LocalBound::beyond(double more, const Plane& start) {
  LocalBound bound(more);
  bound.allowed_.reset(start.window());
  for_each_local_mean(start, [&](int x, int y, double mean) {
    *bound.allowed_.at(x, y) = more + room_for_rounding * mean;
  });
  return bound;
}

bool LocalBound::holds(const Plane& map) const {
  return holds(largest_local_mean(map), [&]() -> const Plane& { return map; });
}

bool LocalBound::holds(double largest, const std::function<const Plane&()>& map) const {
  if (largest <= largest_ || allowed_.samples.empty()) return largest <= largest_;
  bool all = true;
  for_each_local_mean(map(),
                      [&](int x, int y, double mean) { all = all && mean <= *allowed_.at(x, y); });
  return all;
}

}  // namespace gradmesh
