#include "raster/fill.h"

#include <algorithm>
#include <cmath>

namespace gradmesh {
namespace {

constexpr std::int64_t unit = 1 << subpixel_bits;
constexpr std::int64_t half = unit / 2;

/// Smallest integer not below a / b, b > 0.
std::int64_t ceil_div(std::int64_t a, std::int64_t b) {
  const std::int64_t q = a / b;
  return q + (a % b > 0);
}

/// First pixel whose centre is not left of (or above) the coordinate x.
int first_pixel(std::int64_t x) { return int(ceil_div(x - half, unit)); }

/// First pixel of a row whose centre is not left of the line from a to b, b below a. Exact.
int first_pixel_on(const Vertex& a, const Vertex& b, int row) {
  const std::int64_t dy = b.y - a.y;
  const std::int64_t at = row * unit + half - a.y;
  return int(ceil_div((a.x - half) * dy + at * (b.x - a.x), unit * dy));
}

std::uint8_t to_byte(float channel) { return std::uint8_t(std::clamp(channel, 0.f, 255.f) + 0.5f); }

}  // namespace

PatchColor::PatchColor(const Patch& patch, ColorModel model, bool masked_opacity)
    : bilinear_(model == ColorModel::bilinear), opaque_(true), masked_opacity_(masked_opacity) {
  // Rows of the monomial coefficients of the Hermite basis (the paper's B, Eq. 2).
  constexpr double b[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {-3, -2, -1, 3}, {2, 1, 1, -2}};
  const int terms = bilinear_ ? 2 : 4;
  for (int i = 0; i < terms; ++i)
    for (int j = 0; j < terms; ++j) {
      glm::dvec4 sum(0.0);
      for (int k = 0; k < 4; ++k)
        for (int l = 0; l < 4; ++l) sum += patch.c[k][l].color * (b[i][k] * b[j][l]);
      for (int n = 0; n < 4; ++n) c_[i][j][n] = float(sum[n] * (n < 3 ? 255 : 1));
      if (sum[3] != (i + j == 0 ? 1.0 : 0.0)) opaque_ = false;
    }
}

std::array<std::uint8_t, 3> PatchColor::at(float u, float v) const {
  float channel[4];
  for (int n = 0; n < 4; ++n) {
    if (bilinear_) {
      channel[n] = c_[0][0][n] + v * c_[0][1][n] + u * (c_[1][0][n] + v * c_[1][1][n]);
    } else {
      float sum = 0;
      for (int i = 3; i >= 0; --i) {
        const float row = c_[i][0][n] + v * (c_[i][1][n] + v * (c_[i][2][n] + v * c_[i][3][n]));
        sum = sum * u + row;
      }
      channel[n] = sum;
    }
  }
  float alpha = opaque_ ? 1.f : std::clamp(channel[3], 0.f, 1.f);
  if (masked_opacity_ && !opaque_) {
    // The picture under the mask, and the mask, have 8 bits each.
    alpha = float(to_byte(255 * alpha)) / 255;
    for (int n = 0; n < 3; ++n) channel[n] = float(to_byte(channel[n]));
  }
  std::array<std::uint8_t, 3> rgb;
  for (int n = 0; n < 3; ++n)
    rgb[n] = to_byte(alpha * std::clamp(channel[n], 0.f, 255.f) + (1 - alpha) * 255.f);
  return rgb;
}

void fill_triangle(const Triangle& triangle, Face face, const PatchColor& color, Window window,
                   Painting& painting) {
  std::array<Vertex, 3> p = triangle;
  std::ranges::sort(p, {}, [](const Vertex& v) { return std::pair(v.y, v.x); });
  const int y0 = std::max(window.y0, first_pixel(p[0].y));
  const int y1 = std::min(window.y1, first_pixel(p[2].y));
  if (y0 >= y1) return;
  const std::int64_t area =
      (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
  if (area == 0) return;
  const int bend = first_pixel(p[1].y);
  const bool bend_right = area > 0;

  // (u, v) are linear over the triangle; the division is by twice its area in subpixels.
  const double scale = 1.0 / double(area);
  const auto gradient = [&](float Vertex::*m) {
    const double d1 = double(p[1].*m) - p[0].*m, d2 = double(p[2].*m) - p[0].*m;
    return glm::dvec2((d1 * double(p[2].y - p[0].y) - d2 * double(p[1].y - p[0].y)) * scale,
                      (d2 * double(p[1].x - p[0].x) - d1 * double(p[2].x - p[0].x)) * scale);
  };
  const glm::dvec2 du = gradient(&Vertex::u), dv = gradient(&Vertex::v);

  for (int y = y0; y < y1; ++y) {
    const int on_long = first_pixel_on(p[0], p[2], y);
    const int on_short = y < bend ? first_pixel_on(p[0], p[1], y) : first_pixel_on(p[1], p[2], y);
    const int x0 = std::max(window.x0, bend_right ? on_long : on_short);
    const int x1 = std::min(window.x1, bend_right ? on_short : on_long);
    const double dy = double(y * unit + half - p[0].y);
    for (int x = x0; x < x1; ++x) {
      std::uint32_t& top = *painting.top.at(x, y);
      const TopFace with = TopFace(top).with(face);
      top = with.sample();
      if (with.face() != face) continue;
      const double dx = double(x * unit + half - p[0].x);
      // Clamped, since in a sliver rounding could leave the patch.
      const float u = std::clamp(float(p[0].u + du.x * dx + du.y * dy), 0.f, 1.f);
      const float v = std::clamp(float(p[0].v + dv.x * dx + dv.y * dy), 0.f, 1.f);
      painting.image.set_pixel(x, y, color.at(u, v));
    }
  }
}

}  // namespace gradmesh
