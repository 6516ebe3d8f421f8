#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "base/clamped_int.h"
#include "base/parallel.h"
#include "form/smooth_colors.h"
#include "raster/painter.h"
#include "raster/rasterizer.h"

namespace gradmesh {
namespace {

/// Control points of a cubic Bezier curve, in pixels.
using Points = std::array<glm::dvec2, 4>;
/// Colours at a curve's two ends.
using Colors = std::array<glm::dvec4, 2>;
/// A colour with 16 bits per channel.
using Color16 = std::array<int, 4>;

/// Rows that Inkscape paints at a time when it writes a picture.
constexpr int strip_height = 64;
/// A patch or curve of more steps than 2 to that power is cut in halves, and the colour, whose
/// steps are rounded, starts afresh in each. Cairo allows more where all of it lies inside the
/// rectangle that it paints than where it reaches across the border.
constexpr int most_halvings_inside = 8, most_halvings_across = 6;

/// Returns how often a curve must be halved, at least once, so that none of the parts is longer
/// than 1 / sqrt(2): the derivative is a quadratic Bezier curve, bounded by its ends and the
/// middles of its legs.
int halvings(const Points& p) {
  const auto squared = [](glm::dvec2 d) { return glm::dot(d, d); };
  const double longest = std::max({squared(p[1] - p[0]), squared(p[3] - p[2]),
                                   squared(p[2] - p[0]) / 4, squared(p[3] - p[1]) / 4});
  int n = 1;
  while (std::ldexp(1.0, 2 * n) <= 18 * longest) ++n;
  return n;
}

/// Returns both halves of a curve, by de Casteljau's algorithm.
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

std::int64_t fixed(double x, int fractional_bits) {
  return std::llrint(std::ldexp(x, fractional_bits));
}

std::int64_t without_bits(std::int64_t x, int bits) {
  return (x + (std::int64_t(1) << (bits - 1))) >> bits;
}

/// Returns the pixel that holds a position, which is rounded to 1/256.
int pixel(double x) { return int(fixed(x, 8) >> 8); }

/// One coordinate of a curve in cairo's fixed point: the start in 1/256 of a pixel, what has been
/// walked since in 2^-23, the differences in 2^-28.
class FixedWalk {
 public:
  FixedWalk(double start, double d1, double d2, double d3)
      : start_(fixed(start, 8)), d1_(fixed(d1, 28)), d2_(fixed(d2, 28)), d3_(fixed(d3, 28)) {}

  int pixel() const { return int((start_ + without_bits(walked_, 15)) >> 8); }
  void step() {
    walked_ += without_bits(d1_, 5);
    d1_ += d2_;
    d2_ += d3_;
  }

 private:
  std::int64_t start_, walked_ = 0, d1_, d2_, d3_;
};

Color16 color16(const glm::dvec4& color) {
  Color16 result;
  for (int k = 0; k < 4; ++k)
    result[k] = clamped_int(std::clamp(color[k], 0.0, 1.0) * 65535 + 0.5, 0, 65535);
  return result;
}

/// Returns the 8-bit colour over white: cairo's image is premultiplied, 8 bits per channel, and
/// then painted over white.
std::array<std::uint8_t, 3> over_white(const Color16& color) {
  const auto alpha = std::uint32_t(color[3]);
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
  /// Paints in `strip`, the rectangle that cairo paints at a time.
  ForwardPainter(Window strip, Image& image) : strip_(strip), image_(image) {}

  /// Part of a patch, between two v: curves along v through its control points, and the colours
  /// at u = 0 and u = 1 at either v.
  struct Part {
    std::array<Points, 4> rows;
    Colors start, end;
  };

  void paint(const Part& part) {
    Hull hull;
    int n = 0;
    for (const Points& row : part.rows) {
      hull.add(row);
      n = std::max(n, halvings(row));
    }
    if (hull.is_outside(strip_)) return;
    if (n > hull.most_halvings(strip_)) return paint_halves(part);
    const int steps = 1 << n;
    std::array<Differences<glm::dvec2>, 4> rows;
    for (int i = 0; i < 4; ++i) rows[i] = differences(part.rows[i], steps);
    Colors colors = part.start;
    for (int step = 0; step <= steps; ++step) {
      Points curve;
      for (int i = 0; i < 4; ++i) curve[i] = rows[i].value;
      paint_curve(curve, colors);
      for (int i = 0; i < 4; ++i) rows[i].step();
      for (int k = 0; k < 2; ++k) colors[k] += (part.end[k] - part.start[k]) / double(steps);
    }
  }

 private:
  /// The box around control points.
  class Hull {
   public:
    void add(const Points& points) {
      for (const glm::dvec2 p : points) {
        low_ = glm::min(low_, p);
        high_ = glm::max(high_, p);
      }
    }
    bool is_outside(const Window& w) const {
      return low_.x >= w.x1 || low_.y >= w.y1 || high_.x <= w.x0 || high_.y <= w.y0;
    }
    int most_halvings(const Window& w) const {
      const bool is_inside = low_.x >= w.x0 && low_.y >= w.y0 && high_.x <= w.x1 && high_.y <= w.y1;
      return is_inside ? most_halvings_inside : most_halvings_across;
    }

   private:
    glm::dvec2 low_{std::numeric_limits<double>::infinity()}, high_ = -low_;
  };

  void paint_halves(const Part& part) {
    Part first = part, second = part;
    for (int i = 0; i < 4; ++i) {
      const auto [left, right] = halves(part.rows[i]);
      first.rows[i] = left;
      second.rows[i] = right;
    }
    for (int k = 0; k < 2; ++k)
      first.end[k] = second.start[k] = 0.5 * (part.start[k] + part.end[k]);
    paint(first);
    paint(second);
  }

  void paint_curve(const Points& points, const Colors& colors) {
    Hull hull;
    hull.add(points);
    if (hull.is_outside(strip_)) return;
    const int n = halvings(points);
    if (n > hull.most_halvings(strip_)) {
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
    FixedWalk x(d.value.x, d.d1.x, d.d2.x, d.d3.x), y(d.value.y, d.d1.y, d.d2.y, d.d3.y);
    for (int step = 0; step <= steps; ++step) {
      draw(x.pixel(), y.pixel(), color);
      x.step();
      y.step();
      for (int k = 0; k < 4; ++k) color[k] += change[k];
    }
    // Once more the very end, which rounding may have missed.
    draw(pixel(points[3].x), pixel(points[3].y), last);
  }

  void draw(int x, int y, const Color16& color) {
    if (x >= strip_.x0 && x < strip_.x1 && y >= strip_.y0 && y < strip_.y1)
      image_.set_pixel(x, y, over_white(color));
  }

  Window strip_;
  Image& image_;
};

/// Paints a patch with bilinear colour by forward rasterization (Popescu and Rosen): the patch is
/// sampled in steps of less than 1 / sqrt(2) pixel, v by v and along each u, so every pixel that it
/// covers holds a sample; the last sample in a pixel colours it. That lies beside the centre,
/// towards the larger u and v, and pixels that the patch only touches are painted too. Numbers are
/// rounded and added up where cairo does so: FLIP charges 0.03 for a single level of difference.
void paint_forward(const Patch& patch, const Affine& to_pixels, ForwardPainter& painter) {
  const BezierNet net = bezier_net(patch);
  ForwardPainter::Part whole;
  // Far outside every frame, and still a number of steps that ends.
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      whole.rows[i][j] = glm::clamp(to_pixels.point(net[i][j].position), -1e6, 1e6);
  // Inkscape hands colours over as floats.
  const auto color = [&](int i, int j) { return glm::dvec4(glm::vec4(net[i][j].color)); };
  whole.start = {color(0, 0), color(3, 0)};
  whole.end = {color(0, 3), color(3, 3)};
  painter.paint(whole);
}

class CairoLikeRasterizer final : public Rasterizer {
 public:
  Image paint(const Mesh& mesh, const Frame& frame) const override {
    if (mesh.is_smooth()) return paint(painted_mesh(mesh), frame);
    Image image(frame.width, frame.height, 255);
    const int strips = (frame.height + strip_height - 1) / strip_height;
    parallel_for(std::size_t(strips), [&](std::size_t i) {
      Window strip = frame.window();
      strip.y0 = int(i) * strip_height;
      strip.y1 = std::min(frame.height, strip.y0 + strip_height);
      ForwardPainter painter(strip, image);
      for (const Face f : mesh.faces())
        paint_forward(painted_patch(mesh, frame, f), frame.to_pixels, painter);
    });
    return image;
  }
};

}  // namespace

std::unique_ptr<Rasterizer> make_cairo_like_rasterizer() {
  return std::make_unique<CairoLikeRasterizer>();
}

}  // namespace gradmesh
