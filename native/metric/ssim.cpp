#include "metric/ssim.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "metric/ssim.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "metric/filter-inl.h"

// With d = test - reference, m and v the Gaussian mean and variance, x the test and y the
// reference, the two factors of SSIM are
//   luminance  (2 m(x) m(y) + C1) / (m(x)^2 + m(y)^2 + C1) = 1 - m(d)^2 / (m(x)^2 + m(y)^2 + C1)
//   structure  (2 cov(x, y) + C2) / (v(x) + v(y) + C2)     = 1 - v(d) / (v(x) + v(y) + C2)
// so that 1 - SSIM = p + q - p q with the two fractions on the right. This loses nothing to
// cancellation where the images are close, and is exactly 0 where they are equal. The sum of the
// variances is 2 v(y) + 2 cov(y, d) + v(d), which leaves only filters over d for each test.

HWY_BEFORE_NAMESPACE();
namespace gradmesh::HWY_NAMESPACE {
namespace {

constexpr int radius = 5;
/// Variances are taken of bytes less this, as squares of small numbers round less.
constexpr int byte_centre = 128;

template <class T>
const Taps<T, radius>& gaussian() {
  static const auto taps = [] {
    constexpr double sigma = 1.5;
    const auto exact =
        sample_taps<radius>([](int k) { return std::exp(-k * k / (2 * sigma * sigma)); });
    return scaled<T>(exact, 1 / sum(exact));
  }();
  return taps;
}

/// Filters every plane down the columns, with the centres in row y.
template <class T>
HWY_INLINE void filter_columns(const PaddedRows<T>& in, int y, PaddedRows<T>& columns) {
  const Lanes<T> d;
  const Taps<T, radius>& taps = gaussian<T>();
  const int count = in.window().width();
  const std::ptrdiff_t stride = in.stride();
  for (int plane = 0; plane < in.planes(); ++plane) {
    const T* row = in.row(plane, y);
    T* out = columns.row(plane, 0);
    for (int i = 0; i < count; i += hn::Lanes(d))
      hn::Store(filter_unit_sum(d, taps, row + i, stride), d, out + i);
  }
}

/// The planes that are filtered of a channel of the reference, in double, since variances are small
/// differences of them.
enum ReferencePlane { value, square, reference_planes };

void read_reference(const std::uint8_t* y, int count, double* HWY_RESTRICT values,
                    double* HWY_RESTRICT squares) {
  for (int i = 0; i < count; ++i) {
    const double centred = y[i] - byte_centre;
    values[i] = centred;
    squares[i] = centred * centred;
  }
}

void moments_of_row(const PaddedRows<double>& in, int y, PaddedRows<double>& columns, float* mean,
                    float* variance) {
  filter_columns(in, y, columns);
  const Lanes<double> d;
  const hn::Rebind<float, Lanes<double>> df;
  const Taps<double, radius>& taps = gaussian<double>();
  const double* values = columns.row(value, 0) + radius;
  const double* squares = columns.row(square, 0) + radius;
  const int count = in.window().width() - 2 * radius;
  for (int i = 0; i < count; i += hn::Lanes(d)) {
    const auto m = filter_unit_sum(d, taps, values + i, 1);
    const auto v = hn::Sub(filter_unit_sum(d, taps, squares + i, 1), hn::Mul(m, m));
    hn::StoreU(hn::DemoteTo(df, m), df, mean + i);
    hn::StoreU(hn::DemoteTo(df, v), df, variance + i);
  }
}

/// The planes that are filtered of a channel of the difference.
enum DifferencePlane { difference, squared, times_reference, difference_planes };

void read_difference(const std::uint8_t* x, const std::uint8_t* y, int count,
                     float* HWY_RESTRICT differences, float* HWY_RESTRICT squares,
                     float* HWY_RESTRICT products) {
  for (int i = 0; i < count; ++i) {
    const int d = x[i] - y[i];
    differences[i] = float(d);
    squares[i] = float(d * d);
    products[i] = float(d * (y[i] - byte_centre));
  }
}

/// Adds the distances in one channel to `distance`.
void add_distances(const PaddedRows<float>& in, int y, PaddedRows<float>& columns,
                   const float* mean_y, const float* variance_y, float* distance) {
  constexpr float c1 = 6.5025F;   // (0.01 * 255)^2
  constexpr float c2 = 58.5225F;  // (0.03 * 255)^2
  filter_columns(in, y, columns);
  const Lanes<float> d;
  const Taps<float, radius>& taps = gaussian<float>();
  const float* differences = columns.row(difference, 0) + radius;
  const float* squares = columns.row(squared, 0) + radius;
  const float* products = columns.row(times_reference, 0) + radius;
  const int count = in.window().width() - 2 * radius;
  for (int i = 0; i < count; i += hn::Lanes(d)) {
    const auto md = filter_unit_sum(d, taps, differences + i, 1);
    const auto mdd = filter_unit_sum(d, taps, squares + i, 1);
    const auto myd = filter_unit_sum(d, taps, products + i, 1);
    const auto my = hn::LoadU(d, mean_y + i), vy = hn::LoadU(d, variance_y + i);
    const auto m = hn::Add(my, hn::Set(d, float(byte_centre))), mx = hn::Add(m, md);
    const auto means = hn::Add(hn::Mul(m, m), hn::Mul(mx, mx));
    const auto md2 = hn::Mul(md, md);
    const auto p_below = hn::Add(means, hn::Set(d, c1));
    const auto vd = hn::Max(hn::Zero(d), hn::Sub(mdd, md2));
    const auto covariance = hn::Sub(myd, hn::Mul(my, md));
    const auto half = hn::Add(vy, covariance);
    const auto q_below = hn::Add(hn::Add(hn::Add(half, half), vd), hn::Set(d, c2));
    // p + q - p q with p = md2 / p_below and q = vd / q_below, in one division.
    const auto above = hn::Add(hn::Mul(md2, q_below), hn::Mul(vd, hn::Sub(p_below, md2)));
    const auto both = hn::Div(above, hn::Mul(p_below, q_below));
    hn::StoreU(hn::Add(hn::LoadU(d, distance + i), both), d, distance + i);
  }
}

}  // namespace
}  // namespace gradmesh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gradmesh {
namespace {

HWY_EXPORT(read_reference);
HWY_EXPORT(moments_of_row);
HWY_EXPORT(read_difference);
HWY_EXPORT(add_distances);

namespace simd = HWY_NAMESPACE;
using simd::radius;
constexpr int channels = 3;

/// What is filtered for one tile. Kept by a thread, as there may be hundreds of thousands.
template <class T>
struct Scratch {
  PaddedRows<T> planes, columns;

  static Scratch& of_this_thread(Window tile, int count) {
    static thread_local Scratch scratch;
    const Window around = tile.grown(radius);
    scratch.planes.reset(around, count);
    scratch.columns.reset({around.x0, 0, around.x1, 1}, count);
    return scratch;
  }
};

}  // namespace

Ssim::Ssim(Image image) : LocalMetric(std::move(image), radius) {
  const auto read = HWY_DYNAMIC_DISPATCH(read_reference);
  const auto filter = HWY_DYNAMIC_DISPATCH(moments_of_row);
  const Window frame = reference().window();
  moments_.reset(frame, 2 * channels);
  for_each_strip(frame, [&](Window strip) {
    auto& [planes, columns] = Scratch<double>::of_this_thread(strip, simd::reference_planes);
    const Window inside = strip.grown(radius).clipped(frame);
    for (int c = 0; c < channels; ++c) {
      for (int y = inside.y0; y < inside.y1; ++y)
        read(reference().at(inside.x0, y, c), inside.width(), planes.at(simd::value, inside.x0, y),
             planes.at(simd::square, inside.x0, y));
      extend(planes, inside);
      for (int y = strip.y0; y < strip.y1; ++y)
        filter(planes, y, columns, moments_.row(c, y), moments_.row(channels + c, y));
    }
  });
}

void Ssim::score(const Image& test, Window tile, Plane& map) const {
  const auto read = HWY_DYNAMIC_DISPATCH(read_difference);
  const auto add = HWY_DYNAMIC_DISPATCH(add_distances);
  auto& [planes, columns] = Scratch<float>::of_this_thread(tile, simd::difference_planes);
  static thread_local PaddedRows<float> distances;
  distances.reset(tile, 1);
  distances.clear();
  const Window inside = tile.grown(radius).clipped(reference().window());
  for (int c = 0; c < channels; ++c) {
    for (int y = inside.y0; y < inside.y1; ++y)
      read(test.at(inside.x0, y, c), reference().at(inside.x0, y, c), inside.width(),
           planes.at(simd::difference, inside.x0, y), planes.at(simd::squared, inside.x0, y),
           planes.at(simd::times_reference, inside.x0, y));
    extend(planes, inside);
    for (int y = tile.y0; y < tile.y1; ++y)
      add(planes, y, columns, moments_.at(c, tile.x0, y), moments_.at(channels + c, tile.x0, y),
          distances.row(0, y));
  }
  for (int y = tile.y0; y < tile.y1; ++y) {
    const float* sums = distances.row(0, y);
    std::transform(sums, sums + tile.width(), map.at(tile.x0, y),
                   [](float sum) { return sum * (1.0F / channels); });
  }
}

}  // namespace gradmesh
#endif  // HWY_ONCE
