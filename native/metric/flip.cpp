#include "metric/flip.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
  const std::vector<Span> rows(frame.height(), {0, frame.width()});
  for_each_strip(0, rows, [&](const Strip& strip) {
    AppearanceFilter filter(reference(), strip.box);
    for (int y = strip.box.y0; y < strip.box.y1; ++y)
      filter.row(y, rows[y], row_at(appearance_, 0, y));
  });
}

void Flip::score(const Image& test, const Strip& strip, Plane& map) const {
  AppearanceFilter filter(test, strip.box);
  const Plane one_row(strip.box.width(), 1);
  Appearance<Plane> seen = {one_row, one_row, one_row, one_row, one_row};
  const AppearanceRow seen_row = row_at(seen, 0, 0);
  for (int y = strip.box.y0; y < strip.box.y1; ++y) {
    const Span span = strip.rows[y - strip.box.y0];
    if (span.empty()) continue;
    filter.row(y, span, seen_row);
    compare(row_at(appearance_, span.begin, y), seen_row, span.width(), map.at(span.begin, y));
  }
}

}  // namespace gradmesh
