#include "metric/appearance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "metric/elementary.h"
#include "metric/filter.h"

namespace gradmesh {
namespace {

using std::numbers::pi;

using Matrix = std::array<std::array<double, 3>, 3>;

constexpr Matrix operator*(const Matrix& a, const Matrix& b) {
  Matrix product{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) product[i][j] += a[i][k] * b[k][j];
  return product;
}

/// A linear map of three float samples.
struct Linear {
  std::array<std::array<float, 3>, 3> m{};

  explicit constexpr Linear(const Matrix& matrix) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) m[i][j] = float(matrix[i][j]);
  }
  float operator()(int row, float p, float q, float r) const {
    return m[row][0] * p + m[row][1] * q + m[row][2] * r;
  }
};

constexpr double white_x = 0.950428545, white_z = 1.088900371;  // D65, Y = 1
constexpr Matrix rgb_to_xyz = {
    {{10135552 / 24577794.0, 8788810 / 24577794.0, 4435075 / 24577794.0},
     {2613072 / 12288897.0, 8788810 / 12288897.0, 887015 / 12288897.0},
     {1425312 / 73733382.0, 8788810 / 73733382.0, 70074185 / 73733382.0}}};
constexpr Matrix xyz_to_rgb = {{{3.241003275, -1.537398934, -0.498615861},
                                {-0.969224334, 1.875930071, 0.041554224},
                                {0.055639423, -0.204011202, 1.057148933}}};
constexpr Matrix over_white = {{{1 / white_x, 0, 0}, {0, 1, 0}, {0, 0, 1 / white_z}}};
constexpr Matrix times_white = {{{white_x, 0, 0}, {0, 1, 0}, {0, 0, white_z}}};
/// (x, y, z) over white to (y, x - y, y - z) and back.
constexpr Matrix to_opponent = {{{0, 1, 0}, {1, -1, 0}, {0, 1, -1}}};
constexpr Matrix from_opponent = {{{1, 1, 0}, {1, 0, 0}, {1, 0, -1}}};

constexpr Linear rgb_to_white_xyz(over_white* rgb_to_xyz);
constexpr Linear rgb_to_opponent(to_opponent* over_white* rgb_to_xyz);
constexpr Linear opponent_to_rgb(xyz_to_rgb* times_white* from_opponent);

/// Linear light of the 256 values of an sRGB sample (IEC 61966-2-1).
const std::array<float, 256>& linear_light() {
  static const auto table = [] {
    std::array<float, 256> values{};
    for (int i = 0; i < 256; ++i) {
      const double c = i / 255.0;
      values[i] = float(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
    }
    return values;
  }();
  return table;
}

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
      return amplitude * std::exp(-pi * pi * x * x / b);
    });
  }
  static Taps<float, short_reach> normalised(const Taps<double, short_reach>& taps) {
    return scaled<float>(taps, 1 / sum(taps));
  }
  ColourTaps()
      : luminance(normalised(gaussian<short_reach>(0.0047))),
        red_green(normalised(gaussian<short_reach>(0.0053))) {
    constexpr double b_wide = 0.04, b_narrow = 0.025;
    const auto wide = gaussian<reach>(b_wide, std::sqrt(34.1 * std::sqrt(pi / b_wide)));
    const auto narrow = gaussian<reach>(b_narrow, std::sqrt(13.5 * std::sqrt(pi / b_narrow)));
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

/// CIELab's f.
float lab_curve(float t) {
  constexpr float delta = 6 / 29.0F;
  const float root = cube_root(std::max(t, delta * delta * delta));
  return t > delta * delta * delta ? root : t / (3 * delta * delta) + 4 / 29.0F;
}

float in_gamut(float sample) { return std::min(std::max(sample, 0.0F), 1.0F); }

/// Filtered opponent colours to CIELab with Hunt's adjustment. What the filters carry out of the
/// gamut is clamped in linear RGB first.
void perceive(const float* y, const float* cx, const float* cz_wide, const float* cz_narrow,
              int count, float* __restrict lightness, float* __restrict a, float* __restrict b) {
  for (int i = 0; i < count; ++i) {
    const float cz = cz_wide[i] + cz_narrow[i];
    const float red = in_gamut(opponent_to_rgb(0, y[i], cx[i], cz));
    const float green = in_gamut(opponent_to_rgb(1, y[i], cx[i], cz));
    const float blue = in_gamut(opponent_to_rgb(2, y[i], cx[i], cz));
    const float fx = lab_curve(rgb_to_white_xyz(0, red, green, blue));
    const float fy = lab_curve(rgb_to_white_xyz(1, red, green, blue));
    const float fz = lab_curve(rgb_to_white_xyz(2, red, green, blue));
    lightness[i] = 116 * fy - 16;
    const float hunt = 0.01F * lightness[i];
    a[i] = hunt * 500 * (fx - fy);
    b[i] = hunt * 200 * (fy - fz);
  }
}

}  // namespace

AppearanceFilter::AppearanceFilter(const Image& image, Window frame, Window box)
    : luminance_(box.grown(appearance_reach)),
      red_green_(box.grown(appearance_reach)),
      blue_yellow_(box.grown(appearance_reach)),
      box_(box) {
  const auto& light = linear_light();
  const auto convert = [&](int x, int y, int source_x, int source_y) {
    const auto pixel = image.pixel(source_x, source_y);
    const float r = light[pixel[0]], g = light[pixel[1]], b = light[pixel[2]];
    *luminance_.at(x, y) = rgb_to_opponent(0, r, g, b);
    *red_green_.at(x, y) = rgb_to_opponent(1, r, g, b);
    *blue_yellow_.at(x, y) = rgb_to_opponent(2, r, g, b);
  };
  for_each_extended(box.grown(appearance_reach), frame, convert);
  for (Buffer* buffer : {&column_, &smooth_column_, &sloped_column_, &curved_column_}) {
    buffer->resize(box.width() + 2 * appearance_reach);
  }
  for (Buffer* buffer : {&y_, &cx_, &cz_wide_, &cz_narrow_, &dx_, &dy_}) {
    buffer->resize(box.width());
  }
}

void AppearanceFilter::row(int y, const AppearanceRow& out) {
  colour(y, out);
  features(y, out);
}

void AppearanceFilter::colour(int y, const AppearanceRow& out) {
  const auto blur = [&]<int Radius>(const Taps<float, Radius>& taps, const WindowPlane<float>& in,
                                    Buffer& result) {
    filter_even(taps, in.at(box_.x0 - Radius, y), in.stride(), box_.width() + 2 * Radius,
                column_.data());
    filter_even(taps, column_.data() + Radius, 1, box_.width(), result.data());
  };
  const ColourTaps& taps = ColourTaps::get();
  blur(taps.luminance, luminance_, y_);
  blur(taps.red_green, red_green_, cx_);
  blur(taps.blue_yellow_wide, blue_yellow_, cz_wide_);
  blur(taps.blue_yellow_narrow, blue_yellow_, cz_narrow_);
  perceive(y_.data(), cx_.data(), cz_wide_.data(), cz_narrow_.data(), box_.width(), out.lightness,
           out.a, out.b);
}

void AppearanceFilter::features(int y, const AppearanceRow& out) {
  constexpr int reach = FeatureTaps::reach;
  const FeatureTaps& taps = FeatureTaps::get();
  const int count = box_.width();
  const auto down = [&](auto filter, const Taps<float, reach>& axis, Buffer& result) {
    filter(axis, luminance_.at(box_.x0 - reach, y), luminance_.stride(), count + 2 * reach,
           result.data());
  };
  const auto along = [&](auto filter, const Taps<float, reach>& axis, const Buffer& column,
                         Buffer& result) {
    filter(axis, column.data() + reach, 1, count, result.data());
  };
  const auto magnitude = [&](float* result) {
    for (int i = 0; i < count; ++i) result[i] = std::sqrt(dx_[i] * dx_[i] + dy_[i] * dy_[i]);
  };
  const auto even = filter_even<float, reach>;
  const auto odd = filter_odd<float, reach>;
  const auto zero_sum = filter_even_zero_sum<float, reach>;

  down(even, taps.smooth, smooth_column_);
  down(odd, taps.slope, sloped_column_);
  down(zero_sum, taps.curvature, curved_column_);
  along(odd, taps.slope, smooth_column_, dx_);
  along(even, taps.smooth, sloped_column_, dy_);
  magnitude(out.edge);
  along(zero_sum, taps.curvature, smooth_column_, dx_);
  along(even, taps.smooth, curved_column_, dy_);
  magnitude(out.point);
}

}  // namespace gradmesh
