#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "geom/written.h"
#include "mesh/smooth_colors.h"
#include "raster/rasterizer.h"

namespace gradmesh {
namespace {

/// Control points of a cubic Bezier curve, in pixels.
using Points = std::array<glm::dvec2, 4>;
/// Colours at a curve's two ends.
using Colors = std::array<glm::dvec4, 2>;
/// 16 bits per channel.
using Color16 = std::array<int, 4>;

/// A curve of more steps than 2 to that power is cut in halves, and the colour, whose steps are
/// rounded, starts afresh in each. Cairo allows four times as many for what lies wholly inside
/// the rectangle that it paints; but Inkscape paints strips of 64 pixels, wherever they lie.
constexpr int most_halvings = 6;
/// Cairo rounds positions to 1/256 of a pixel before it cuts off the fraction.
constexpr double rounding = 1.0 / 512;

/// How often a curve must be halved so that none of the parts is longer than 1 / sqrt(2): the
/// derivative is a quadratic Bezier curve, bounded by its ends and the middles of its legs.
int halvings(const Points& p) {
  const auto squared = [](glm::dvec2 d) { return glm::dot(d, d); };
  const double longest = std::max({squared(p[1] - p[0]), squared(p[3] - p[2]),
                                   squared(p[2] - p[0]) / 4, squared(p[3] - p[1]) / 4});
  int n = 0;
  while (std::ldexp(1.0, 2 * n) <= 18 * longest) ++n;
  return n;
}

/// De Casteljau.
std::array<Points, 2> halves(const Points& p) {
  const glm::dvec2 a = 0.5 * (p[0] + p[1]), b = 0.5 * (p[1] + p[2]), c = 0.5 * (p[2] + p[3]);
  const glm::dvec2 d = 0.5 * (a + b), e = 0.5 * (b + c), middle = 0.5 * (d + e);
  return {Points{p[0], a, d, middle}, Points{middle, e, c, p[3]}};
}

/// A cubic's value and its first three forward differences.
template <class T>
struct Differences {
  T value, d1, d2, d3;

  void step() {
    value += d1;
    d1 += d2;
    d2 += d3;
  }
};

Differences<glm::dvec2> differences(const Points& p, int steps) {
  const double h = 1.0 / steps;
  const glm::dvec2 a = 3.0 * h * (p[1] - p[0]);
  const glm::dvec2 b = 3.0 * h * h * (p[0] - 2.0 * p[1] + p[2]);
  const glm::dvec2 c = h * h * h * (p[3] - p[0] + 3.0 * (p[1] - p[2]));
  return {p[0], a + b + c, 2.0 * b + 6.0 * c, 6.0 * c};
}

/// 32 fractional bits.
std::int64_t fixed(double x) { return std::llround(std::ldexp(x, 32)); }
std::int64_t pixel(std::int64_t x) { return x >> 32; }

Color16 color16(const glm::dvec4& color) {
  Color16 result;
  for (int k = 0; k < 4; ++k) result[k] = int(std::clamp(color[k], 0.0, 1.0) * 65535 + 0.5);
  return result;
}

/// Cairo's image is premultiplied, 8 bits per channel; it is then painted over white.
std::array<std::uint8_t, 3> over_white(const Color16& color) {
  const std::uint32_t alpha = std::uint32_t(color[3]);
  const std::uint32_t white = 255 - (alpha >> 8);
  std::array<std::uint8_t, 3> rgb;
  for (int k = 0; k < 3; ++k) {
    // Divided by 65535, rounded; the upper 8 of the 16 bits are then taken.
    std::uint32_t product = std::uint32_t(color[k]) * alpha + 0x8000;
    product += product >> 16;
    rgb[k] = std::uint8_t((product >> 24) + white);
  }
  return rgb;
}

class ForwardPainter {
 public:
  ForwardPainter(Window window, Image& image) : window_(window), image_(image) {}

  /// Part of a patch, between two v: curves along v through its control points, and the colours
  /// at u = 0 and u = 1 at either v.
  struct Strip {
    std::array<Points, 4> rows;
    Colors start, end;
  };

  void paint(const Strip& strip) {
    int n = 0;
    for (const Points& row : strip.rows) n = std::max(n, halvings(row));
    if (n > most_halvings) return paint_halves(strip);
    const int steps = 1 << n;
    std::array<Differences<glm::dvec2>, 4> rows;
    for (int i = 0; i < 4; ++i) rows[i] = differences(strip.rows[i], steps);
    for (int step = 0; step <= steps; ++step) {
      const double t = double(step) / steps;
      Points curve;
      Colors colors;
      for (int i = 0; i < 4; ++i) curve[i] = rows[i].value;
      for (int k = 0; k < 2; ++k) colors[k] = glm::mix(strip.start[k], strip.end[k], t);
      paint_curve(curve, colors);
      for (int i = 0; i < 4; ++i) rows[i].step();
    }
  }

 private:
  void paint_halves(const Strip& strip) {
    Strip first = strip, second = strip;
    for (int i = 0; i < 4; ++i) {
      const auto [left, right] = halves(strip.rows[i]);
      first.rows[i] = left;
      second.rows[i] = right;
    }
    for (int k = 0; k < 2; ++k)
      first.end[k] = second.start[k] = 0.5 * (strip.start[k] + strip.end[k]);
    paint(first);
    paint(second);
  }

  void paint_curve(const Points& points, const Colors& colors) {
    if (is_outside(points)) return;
    const int n = halvings(points);
    if (n > most_halvings) {
      const auto [first, second] = halves(points);
      const glm::dvec4 middle = 0.5 * (colors[0] + colors[1]);
      paint_curve(first, {colors[0], middle});
      paint_curve(second, {middle, colors[1]});
      return;
    }
    const int steps = 1 << n;
    const Color16 last = color16(colors[1]);
    Color16 color = color16(colors[0]), change;
    // Towards zero, so that the sum stays between the ends.
    for (int k = 0; k < 4; ++k) change[k] = (last[k] - color[k]) / steps;

    const Differences<glm::dvec2> d = differences(points, steps);
    Differences<std::int64_t> x{fixed(d.value.x + rounding), fixed(d.d1.x), fixed(d.d2.x),
                                fixed(d.d3.x)};
    Differences<std::int64_t> y{fixed(d.value.y + rounding), fixed(d.d1.y), fixed(d.d2.y),
                                fixed(d.d3.y)};
    for (int step = 0; step <= steps; ++step) {
      draw(pixel(x.value), pixel(y.value), color);
      x.step();
      y.step();
      for (int k = 0; k < 4; ++k) color[k] += change[k];
    }
    // Once more the very end, which rounding may have missed.
    draw(pixel(fixed(points[3].x + rounding)), pixel(fixed(points[3].y + rounding)), last);
  }

  bool is_outside(const Points& p) const {
    const glm::dvec2 low = glm::min(glm::min(p[0], p[1]), glm::min(p[2], p[3])) - 1.0;
    const glm::dvec2 high = glm::max(glm::max(p[0], p[1]), glm::max(p[2], p[3])) + 1.0;
    return high.x < window_.x0 || high.y < window_.y0 || low.x > window_.x1 || low.y > window_.y1;
  }

  void draw(std::int64_t x, std::int64_t y, const Color16& color) {
    if (x >= window_.x0 && x < window_.x1 && y >= window_.y0 && y < window_.y1)
      image_.set_pixel(int(x), int(y), over_white(color));
  }

  Window window_;
  Image& image_;
};

/// Paints a patch with bilinear colour by forward rasterization (Popescu and Rosen): the patch is
/// sampled in steps of less than 1 / sqrt(2) pixel, v by v and along each u, so every pixel that it
/// covers holds a sample; the last sample in a pixel colours it. That lies beside the centre,
/// towards the larger u and v, and pixels that the patch only touches are painted too. Numbers are
/// rounded where cairo rounds them: FLIP charges 0.03 for a single level of difference.
void paint_forward(const Patch& patch, const Affine& to_pixels, Window window, Image& image) {
  const BezierNet net = bezier_net(patch);
  ForwardPainter::Strip whole;
  // Far outside every frame, and still a number of steps that ends.
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      whole.rows[i][j] = glm::clamp(to_pixels.point(net[i][j].position), -1e6, 1e6);
  whole.start = {net[0][0].color, net[3][0].color};
  whole.end = {net[0][3].color, net[3][3].color};
  ForwardPainter(window, image).paint(whole);
}

/// Rows that one thread paints at a time. A patch is sampled again in each band that it reaches.
constexpr int band_height = 128;

class CairoLikeRasterizer final : public Rasterizer {
 public:
  void paint(const Mesh& mesh, const Frame& frame, Window window, Image& image) const override {
    if (mesh.is_smooth()) return paint(painted_mesh(mesh), frame, window, image);
    const bool as_stops = mesh.color_model() == ColorModel::bilinear;
    window = window.clipped(frame.window());
    const int bands = (window.height() + band_height - 1) / band_height;
    parallel_for(std::size_t(bands), [&](std::size_t i) {
      Window band = window;
      band.y0 = window.y0 + int(i) * band_height;
      band.y1 = std::min(window.y1, band.y0 + band_height);
      fill(image, band, std::uint8_t(255));
      for (const Face f : mesh.faces()) {
        Patch patch = mesh.patch(f);
        if (as_stops) patch = as_written(patch, frame.coons_tolerance, frame.masked_opacity);
        if (!pixel_bounds(patch, frame).clipped(band).empty())
          paint_forward(patch, frame.to_pixels, band, image);
      }
    });
  }
};

}  // namespace

std::unique_ptr<Rasterizer> make_cairo_like_rasterizer() {
  return std::make_unique<CairoLikeRasterizer>();
}

}  // namespace gradmesh
