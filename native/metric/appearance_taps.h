#pragma once

#include <cmath>
#include <numbers>

#include "metric/taps.h"

namespace gradmesh {

/// The distance in pixels, along each axis, up to which a pixel changes the appearance.
inline constexpr int appearance_reach = 10;

/// Spatial filters of the colour pipeline: contrast sensitivity as Gaussians exp(-pi^2 x^2 / b), x
/// in degrees. Blue-yellow is the sum of a wide and a narrow one. The other two are cut where their
/// taps sink below 1e-11, far beneath a float's rounding.
struct ColourTaps {
  static constexpr int reach = appearance_reach, short_reach = 7;
  Taps<float, short_reach> luminance, red_green;
  Taps<float, reach> blue_yellow_wide, blue_yellow_narrow;

  static const ColourTaps& get() {
    static const ColourTaps taps;
    return taps;
  }

 private:
  template <int Radius>
  static Taps<double, Radius> gaussian(double b, double amplitude = 1) {
    constexpr double pixels_per_degree = 67.0206451;
    return sample_taps<Radius>([=](int k) {
      const double x = k / pixels_per_degree;
      return amplitude * std::exp(-std::numbers::pi * std::numbers::pi * x * x / b);
    });
  }
  static Taps<float, short_reach> normalised(const Taps<double, short_reach>& taps) {
    return scaled<float>(taps, 1 / sum(taps));
  }
  ColourTaps()
      : luminance(normalised(gaussian<short_reach>(0.0047))),
        red_green(normalised(gaussian<short_reach>(0.0053))) {
    constexpr double b_wide = 0.04, b_narrow = 0.025;
    const auto wide =
        gaussian<reach>(b_wide, std::sqrt(34.1 * std::sqrt(std::numbers::pi / b_wide)));
    const auto narrow =
        gaussian<reach>(b_narrow, std::sqrt(13.5 * std::sqrt(std::numbers::pi / b_narrow)));
    const double scale = 1 / std::hypot(sum(wide), sum(narrow));
    blue_yellow_wide = scaled<float>(wide, scale);
    blue_yellow_narrow = scaled<float>(narrow, scale);
  }
};

/// Filters of the feature pipeline: a Gaussian and its derivatives, whose positive and negative
/// taps sum to 1 and -1.
struct FeatureTaps {
  static constexpr int reach = 9;
  Taps<float, reach> smooth, slope, curvature;

  static const FeatureTaps& get() {
    static const FeatureTaps taps;
    return taps;
  }

 private:
  FeatureTaps() {
    constexpr double sigma = 2.74785;  // half of 0.082 degrees in pixels
    const auto gaussian = [](int k) { return std::exp(-k * k / (2 * sigma * sigma)); };
    const auto g = sample_taps<reach>(gaussian);
    const auto first = sample_taps<reach>([&](int k) { return k * gaussian(k); });
    const auto second =
        sample_taps<reach>([&](int k) { return (k * k / (sigma * sigma) - 1) * gaussian(k); });
    smooth = scaled<float>(g, 1 / sum(g));
    slope = scaled<float>(first, 2 / sum(first));
    double positive = 0, negative = second.at[0];
    for (int k = 1; k <= reach; ++k) (second.at[k] > 0 ? positive : negative) += 2 * second.at[k];
    for (int k = 0; k <= reach; ++k) {
      curvature.at[k] = float(second.at[k] / std::abs(second.at[k] > 0 ? positive : negative));
    }
  }
};

}  // namespace gradmesh
