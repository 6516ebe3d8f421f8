#include "metric/flip.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "metric/elementary.h"

namespace gradmesh {
namespace {

using ConstAppearanceRow = Appearance<const float*>;

/// The row of every plane from column x on; pointers to const where the planes are.
template <class Planes>
auto row_at(Planes& planes, int x, int y) {
  return Appearance<decltype(planes.a.at(x, y))>{planes.lightness.at(x, y), planes.a.at(x, y),
                                                 planes.b.at(x, y), planes.edge.at(x, y),
                                                 planes.point.at(x, y)};
}

/// Maps a colour distance to 0..1 so that the greatest one, green against blue, becomes 1 and
/// distances from 0.4 of that on share the last twentieth (the paper's error redistribution).
float remapped(float distance) {
  constexpr float greatest = 41.276096F, knee = 0.4F * greatest, at_knee = 0.95F;
  constexpr float below = at_knee / knee, above = (1 - at_knee) / (greatest - knee);
  return distance < knee ? distance * below : at_knee + (distance - knee) * above;
}

/// HyAB distance of the colours, strengthened where edges or points differ as well.
void compare(const ConstAppearanceRow& s, const AppearanceRow& t, int count,
             float* __restrict out) {
  constexpr float exponent = 0.7F;
  constexpr float half_sqrt = 0.707106781F;
  for (int i = 0; i < count; ++i) {
    const float da = s.a[i] - t.a[i], db = s.b[i] - t.b[i];
    const float hyab = std::abs(s.lightness[i] - t.lightness[i]) + std::sqrt(da * da + db * db);
    const float colour = remapped(power(hyab, exponent));
    const float feature =
        std::max(std::abs(s.edge[i] - t.edge[i]), std::abs(s.point[i] - t.point[i]));
    out[i] = power(colour, 1 - std::sqrt(feature * half_sqrt));
  }
}

}  // namespace

Flip::Flip(Image image) : LocalMetric(std::move(image), appearance_reach) {
  const Window frame = reference().window();
  const Plane plane(frame.width(), frame.height());
  appearance_ = {plane, plane, plane, plane, plane};
  constexpr int strip_height = 32;
  parallel_for((frame.height() + strip_height - 1) / strip_height, [&](std::size_t i) {
    const int y0 = int(i) * strip_height, y1 = std::min(y0 + strip_height, frame.y1);
    AppearanceFilter filter(reference(), frame, {0, y0, frame.x1, y1});
    for (int y = y0; y < y1; ++y) filter.row(y, row_at(appearance_, 0, y));
  });
}

void Flip::score(const Image& test, Window tile, Plane& map) const {
  AppearanceFilter filter(test, reference().window(), tile);
  const Plane one_row(tile.width(), 1);
  Appearance<Plane> seen = {one_row, one_row, one_row, one_row, one_row};
  const AppearanceRow seen_row = row_at(seen, 0, 0);
  for (int y = tile.y0; y < tile.y1; ++y) {
    filter.row(y, seen_row);
    compare(row_at(appearance_, tile.x0, y), seen_row, tile.width(), map.at(tile.x0, y));
  }
}

}  // namespace gradmesh
