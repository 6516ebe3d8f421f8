#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "base/image.h"

/// SSIM and FLIP written down from their definitions, in double, with whole two-dimensional
/// kernels and nothing shared with the library: what the fast ones are held against.
namespace gradmesh::naive {

using Field = std::function<double(int x, int y)>;
using Kernel = std::function<double(int dx, int dy)>;
using Color = std::array<double, 3>;

/// Continues a field beyond the frame with its nearest pixel.
inline Field extended(const Field& field, Window frame) {
  return [=](int x, int y) {
    return field(std::clamp(x, 0, frame.x1 - 1), std::clamp(y, 0, frame.y1 - 1));
  };
}

inline double filtered(const Field& field, const Kernel& kernel, int radius, int x, int y) {
  double total = 0;
  for (int dy = -radius; dy <= radius; ++dy)
    for (int dx = -radius; dx <= radius; ++dx) total += kernel(dx, dy) * field(x + dx, y + dy);
  return total;
}

/// The kernel's samples, divided by their sum.
inline Kernel normalised(const Kernel& kernel, int radius) {
  const double total = filtered([](int, int) { return 1.0; }, kernel, radius, 0, 0);
  return [=](int dx, int dy) { return kernel(dx, dy) / total; };
}

/// The kernel's samples, the positive ones divided by their sum and the negative ones by theirs.
inline Kernel balanced(const Kernel& kernel, int radius) {
  double positive = 0, negative = 0;
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) {
      positive += std::max(kernel(dx, dy), 0.0);
      negative -= std::min(kernel(dx, dy), 0.0);
    }
  }
  return [=](int dx, int dy) {
    const double k = kernel(dx, dy);
    return k > 0 ? k / positive : k / negative;
  };
}

inline double one_minus_ssim(const Image& a, const Image& b, int x, int y) {
  constexpr int radius = 5;
  constexpr double c1 = 0.01 * 0.01 * 255 * 255, c2 = 0.03 * 0.03 * 255 * 255;
  const Kernel gaussian = normalised(
      [](int dx, int dy) { return std::exp(-(dx * dx + dy * dy) / (2 * 1.5 * 1.5)); }, radius);
  double total = 0;
  for (int c = 0; c < 3; ++c) {
    const auto blur = [&](const Field& f) {
      return filtered(extended(f, a.window()), gaussian, radius, x, y);
    };
    const Field fa = [&](int i, int j) { return double(*a.at(i, j, c)); };
    const Field fb = [&](int i, int j) { return double(*b.at(i, j, c)); };
    const double ma = blur(fa), mb = blur(fb);
    const double va = blur([&](int i, int j) { return std::pow(fa(i, j) - ma, 2); });
    const double vb = blur([&](int i, int j) { return std::pow(fb(i, j) - mb, 2); });
    const double cov = blur([&](int i, int j) { return (fa(i, j) - ma) * (fb(i, j) - mb); });
    total += 1 - (2 * ma * mb + c1) * (2 * cov + c2) / ((ma * ma + mb * mb + c1) * (va + vb + c2));
  }
  return total / 3;
}

inline Color linear_xyz(const Color& rgb) {
  const auto [r, g, b] = rgb;
  return {(10135552 * r + 8788810 * g + 4435075 * b) / 24577794,
          (2613072 * r + 8788810 * g + 887015 * b) / 12288897,
          (1425312 * r + 8788810 * g + 70074185 * b) / 73733382};
}

inline constexpr Color white = {0.950428545, 1, 1.088900371};

/// Y, Cx and Cz.
inline Color opponent(const std::array<std::uint8_t, 3>& pixel) {
  Color rgb;
  for (int c = 0; c < 3; ++c) {
    const double s = pixel[c] / 255.0;
    rgb[c] = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  }
  const Color xyz = linear_xyz(rgb);
  const double x = xyz[0] / white[0], y = xyz[1] / white[1], z = xyz[2] / white[2];
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// Contrast sensitivity of Y, Cx or Cz: a sum of Gaussians (a, b) in degrees.
inline Kernel contrast_sensitivity(int channel, int radius) {
  using std::numbers::pi;
  const auto gaussian = [](double a, double b, int dx, int dy) {
    constexpr double ppd = 67.0206451;
    return a * pi / b * std::exp(-pi * pi * (dx * dx + dy * dy) / (ppd * ppd) / b);
  };
  if (channel < 2) {
    const double b = channel == 0 ? 0.0047 : 0.0053;
    return normalised([=](int dx, int dy) { return gaussian(1, b, dx, dy); }, radius);
  }
  // The amplitudes a sqrt(pi / b) of the published code, not the a pi / b of a true transform.
  return normalised(
      [=](int dx, int dy) {
        return gaussian(34.1 * std::sqrt(0.04 / pi), 0.04, dx, dy) +
               gaussian(13.5 * std::sqrt(0.025 / pi), 0.025, dx, dy);
      },
      radius);
}

/// CIELab with Hunt's adjustment, from Y, Cx and Cz.
inline Color hunt_lab(const Color& ycc) {
  const double y = (ycc[0] + 16) / 116, x = y + ycc[1] / 500, z = y - ycc[2] / 200;
  const double xx = x * white[0], yy = y * white[1], zz = z * white[2];
  const Color rgb = {std::clamp(3.241003275 * xx - 1.537398934 * yy - 0.498615861 * zz, 0.0, 1.0),
                     std::clamp(-0.969224334 * xx + 1.875930071 * yy + 0.041554224 * zz, 0.0, 1.0),
                     std::clamp(0.055639423 * xx - 0.204011202 * yy + 1.057148933 * zz, 0.0, 1.0)};
  const Color xyz = linear_xyz(rgb);
  const auto f = [](double t) {
    constexpr double delta = 6.0 / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
  };
  const double fx = f(xyz[0] / white[0]), fy = f(xyz[1] / white[1]), fz = f(xyz[2] / white[2]);
  const double lightness = 116 * fy - 16;
  return {lightness, 0.01 * lightness * 500 * (fx - fy), 0.01 * lightness * 200 * (fy - fz)};
}

/// HyAB distance of the colours that an eye resolves.
inline double flip_colour(const Image& a, const Image& b, int x, int y) {
  constexpr int radius = 10;
  const auto seen = [&](const Image& image) {
    Color color;
    for (int c = 0; c < 3; ++c) {
      const Field field = [&](int i, int j) { return opponent(image.pixel(i, j))[c]; };
      color[c] =
          filtered(extended(field, image.window()), contrast_sensitivity(c, radius), radius, x, y);
    }
    return hunt_lab(color);
  };
  const Color s = seen(a), t = seen(b);
  return std::abs(s[0] - t[0]) + std::hypot(s[1] - t[1], s[2] - t[2]);
}

inline double flip_feature(const Image& a, const Image& b, int x, int y) {
  constexpr int radius = 9;
  constexpr double sigma = 0.5 * 0.082 * 67.0206451;
  const auto gaussian = [=](int dx, int dy) {
    return std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma));
  };
  const Kernel slope = balanced([=](int dx, int dy) { return dx * gaussian(dx, dy); }, radius);
  const Kernel curvature = balanced(
      [=](int dx, int dy) { return (dx * dx / (sigma * sigma) - 1) * gaussian(dx, dy); }, radius);
  const auto magnitude = [&](const Image& image, const Kernel& kernel) {
    const Field luminance = extended(
        [&](int i, int j) { return (opponent(image.pixel(i, j))[0] + 16) / 116; }, image.window());
    const Kernel turned = [&](int dx, int dy) { return kernel(dy, dx); };
    return std::hypot(filtered(luminance, kernel, radius, x, y),
                      filtered(luminance, turned, radius, x, y));
  };
  const double edge = std::abs(magnitude(a, slope) - magnitude(b, slope));
  const double point = std::abs(magnitude(a, curvature) - magnitude(b, curvature));
  return std::sqrt(std::max(edge, point) / std::numbers::sqrt2);
}

inline double flip(double colour, double feature) {
  const double distance = std::pow(colour, 0.7);
  constexpr double greatest = 41.276096, knee = 0.4 * greatest;
  const double remapped = distance < knee ? distance * 0.95 / knee
                                          : 0.95 + (distance - knee) / (greatest - knee) * 0.05;
  return std::pow(remapped, 1 - feature);
}

}  // namespace gradmesh::naive
