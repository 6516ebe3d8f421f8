#include "metric/edge_shift.h"

#include <algorithm>
#include <cmath>

namespace gradmesh {
namespace {

/// Half the side of the windows over which a shift is found.
constexpr int reach = 4;
/// Brightness of white. Whole numbers make sums that do not depend on where they began, and small
/// ones fit 32 bits.
constexpr int white = 255 * 4;
/// The slope by a pixel, as a share of white, from which a place counts as an edge: where a slope
/// is smaller, nobody sees a shift by a pixel. A third of a window has to be as steep.
constexpr double steep = 0.02;

using Sums = Raster<std::int32_t, 1>;

/// Writes the brightness of a row's pixels in a window.
void read_brightness(const Image& image, int y, Window window, std::int32_t* row) {
  const std::uint8_t *r = image.at(window.x0, y, 0), *g = image.at(window.x0, y, 1),
                     *b = image.at(window.x0, y, 2);
  // Of Rec. 601, over 64.
  for (int i = 0; i < window.width(); ++i) row[i] = (77 * r[i] + 150 * g[i] + 29 * b[i]) >> 6;
}

/// Returns the sums of values over the squares around each pixel of a window, as far as the squares
/// lie in the window of the values.
Sums sums_around(const Sums& values, Window window) {
  const Window all = values.window();
  Sums across(Window{window.x0, all.y0, window.x1, all.y1}), sums(window);
  for (int y = all.y0; y < all.y1; ++y) {
    const std::int32_t* const row = values.at(all.x0, y) - all.x0;
    std::int32_t* const to = across.at(window.x0, y) - window.x0;
    std::int32_t sum = 0;
    for (int x = std::max(window.x0 - reach, all.x0); x < std::min(window.x0 + reach, all.x1); ++x)
      sum += row[x];
    for (int x = window.x0; x < window.x1; ++x) {
      if (x + reach < all.x1) sum += row[x + reach];
      to[x] = sum;
      if (x - reach >= all.x0) sum -= row[x - reach];
    }
  }
  std::vector<std::int32_t> column(std::size_t(window.width()), 0);
  const auto add = [&](int y, int sign) {
    const std::int32_t* const row = across.at(window.x0, y);
    for (std::size_t i = 0; i < column.size(); ++i) column[i] += sign * row[i];
  };
  for (int y = std::max(window.y0 - reach, all.y0); y < std::min(window.y0 + reach, all.y1); ++y)
    add(y, 1);
  for (int y = window.y0; y < window.y1; ++y) {
    if (y + reach < all.y1) add(y + reach, 1);
    std::ranges::copy(column, sums.at(window.x0, y));
    if (y - reach >= all.y0) add(y - reach, -1);
  }
  return sums;
}

}  // namespace

EdgeShift::EdgeShift(const Image& reference, const Raster<std::uint8_t, 1>& counts)
    : brightness_(reference.window()), slopes_(reference.window()), edges_(reference.window()) {
  const Window all = reference.window();
  for (int y = all.y0; y < all.y1; ++y)
    read_brightness(reference, y, all, brightness_.at(all.x0, y));
  Sums xx(all), xy(all), yy(all);
  for (int y = all.y0 + 1; y < all.y1 - 1; ++y)
    for (int x = all.x0 + 1; x < all.x1 - 1; ++x) {
      const std::int32_t by_x = (*brightness_.at(x + 1, y) - *brightness_.at(x - 1, y)) / 2;
      const std::int32_t by_y = (*brightness_.at(x, y + 1) - *brightness_.at(x, y - 1)) / 2;
      const bool is_steep = by_x * by_x + by_y * by_y >= steep * white * steep * white;
      if (!is_steep || !*counts.at(x, y)) continue;
      slopes_.set_pixel(x, y, {by_x, by_y});
      *xx.at(x, y) = by_x * by_x;
      *xy.at(x, y) = by_x * by_y;
      *yy.at(x, y) = by_y * by_y;
    }
  xx = sums_around(xx, all);
  xy = sums_around(xy, all);
  yy = sums_around(yy, all);
  constexpr double side = 2 * reach + 1,
                   least = side * side / 3 * (steep * white) * (steep * white);
  for (int y = all.y0; y < all.y1; ++y)
    for (int x = all.x0; x < all.x1; ++x) {
      const double a = *xx.at(x, y), b = *xy.at(x, y), c = *yy.at(x, y);
      if (a + c < least) continue;
      const double angle = 0.5 * std::atan2(2 * b, a - c);
      const double cos = std::cos(angle), sin = std::sin(angle);
      const double squares = a * cos * cos + 2 * b * cos * sin + c * sin * sin;
      if (squares < least) continue;
      edges_.set_pixel(x, y, {float(cos / squares), float(sin / squares)});
      where_ = where_.united({x, y, x + 1, y + 1});
    }
}

void EdgeShift::update(const Image& test, Window changed, Plane& map) const {
  const Window all = brightness_.window();
  const Window window = changed.grown(reach).clipped(where_),
               read = window.grown(reach).clipped(all);
  if (window.empty()) return;
  Sums by_x(read), by_y(read);
  std::vector<std::int32_t> row(std::size_t(read.width()));
  for (int y = read.y0; y < read.y1; ++y) {
    read_brightness(test, y, read, row.data());
    const std::int32_t* const before = brightness_.at(read.x0, y);
    const std::int32_t *slope_x = slopes_.at(read.x0, y, 0), *slope_y = slopes_.at(read.x0, y, 1);
    std::int32_t *to_x = by_x.at(read.x0, y), *to_y = by_y.at(read.x0, y);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::int32_t difference = row[i] - before[i];
      to_x[i] = slope_x[i] * difference;
      to_y[i] = slope_y[i] * difference;
    }
  }
  by_x = sums_around(by_x, window);
  by_y = sums_around(by_y, window);
  for (int y = window.y0; y < window.y1; ++y) {
    const float *edge_x = edges_.at(window.x0, y, 0), *edge_y = edges_.at(window.x0, y, 1);
    const std::int32_t *x = by_x.at(window.x0, y), *of_y = by_y.at(window.x0, y);
    float* const to = map.at(window.x0, y);
    for (int i = 0; i < window.width(); ++i)
      to[i] = std::abs(edge_x[i] * float(x[i]) + edge_y[i] * float(of_y[i]));
  }
}

}  // namespace gradmesh
