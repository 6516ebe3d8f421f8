#include "metric/ssim.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/per_thread.h"
#include "metric/padded_rows.h"

// What every target shares, read once.
#ifndef GRADMESH_METRIC_SSIM_SHARED
#define GRADMESH_METRIC_SSIM_SHARED
namespace gradmesh {
namespace {

constexpr int channels = 3;
constexpr int radius = ssim_radius;
/// The value that is subtracted from bytes, since small numbers and their squares round less.
constexpr int byte_centre = 128;
/// The number of rows for which columns are filtered at a time; these share most of their input.
constexpr int rows_at_once = 4;

/// Buffers for one tile. Each thread keeps its own, as there may be hundreds of thousands of tiles.
struct Scratch {
  PaddedRows<float> planes, columns;

  /// Resets the buffers. The planes extend beyond the tile by the radius of the filter, and further
  /// down for the rows that are filtered together with the last one; the results for those are not
  /// used.
  void reset(Window tile, int plane_count, int column_count) {
    Window around = tile.grown(radius);
    columns.reset({around.x0, 0, around.x1, rows_at_once}, column_count);
    around.y1 += rows_at_once - 1;
    planes.reset(around, plane_count);
  }
};

}  // namespace
}  // namespace gradmesh
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "metric/ssim.cpp"
#include <hwy/cache_control.h>
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

using Rows = PaddedRows<float>;
using D = Lanes<float>;
using V = hn::Vec<D>;
constexpr D d;

// The reference's variance is the mean of the columns' variances plus the variance of their means.
// Both are taken about a sample near the centre, where nothing large cancels: as that has at least
// 0.11 of the weight, at least so much of the mean square about it is left. A float's rounding then
// moves the variance by some millionths of itself, however bright and flat the image is.

enum ReferenceColumn { column_mean, column_variance, reference_columns };

void read_reference(const std::uint8_t* y, int count, float* values) {
  for_each_vector(d, count, [=](auto df, int i) {
    const hn::RebindToSigned<decltype(df)> di;
    const hn::Rebind<std::uint8_t, decltype(df)> bytes;
    const auto centred =
        hn::Sub(hn::PromoteTo(di, hn::LoadU(bytes, y + i)), hn::Set(di, byte_centre));
    hn::StoreU(hn::ConvertTo(df, centred), df, values + i);
  });
}

/// Finds the moments of a vector of columns, computed about `near`.
HWY_INLINE void find_column_moments(const float* in, std::ptrdiff_t stride, V near, V& mean,
                                    V& variance) {
  const Taps<float, radius>& taps = ssim_taps();
  V shift = hn::Zero(d), squares = shift;
  for (int k = radius; k > 0; --k) {
    const V above = hn::Sub(hn::Load(d, in - k * stride), near);
    const V below = hn::Sub(hn::Load(d, in + k * stride), near);
    shift = add_even(d, shift, taps.at[k], above, below);
    squares = add_even(d, squares, taps.at[k], hn::Mul(above, above), hn::Mul(below, below));
  }
  const V tap = hn::Set(d, taps.at[0]), centre = hn::Sub(hn::Load(d, in), near);
  shift = hn::Add(shift, hn::Mul(tap, centre));
  squares = hn::Add(squares, hn::Mul(tap, hn::Mul(centre, centre)));
  mean = hn::Add(near, shift);
  variance = hn::Sub(squares, hn::Mul(shift, shift));
}

/// Finds the moments of all columns with their centres in the `rows_at_once` rows from y on.
void moments_of_columns(const Rows& in, int y, Rows& columns) {
  static_assert(rows_at_once == 4);
  const std::ptrdiff_t stride = in.stride(), out_stride = columns.stride();
  float *means = columns.row(column_mean, 0), *variances = columns.row(column_variance, 0);
  for (int i = 0; i < in.window().width(); i += int(hn::Lanes(d))) {
    const float* at = in.row(0, y) + i;
    const V near = hn::Load(d, at + 2 * stride);
    V mean_0, mean_1, mean_2, mean_3, variance_0, variance_1, variance_2, variance_3;
    find_column_moments(at, stride, near, mean_0, variance_0);
    find_column_moments(at + stride, stride, near, mean_1, variance_1);
    find_column_moments(at + 2 * stride, stride, near, mean_2, variance_2);
    find_column_moments(at + 3 * stride, stride, near, mean_3, variance_3);
    hn::Store(mean_0, d, means + i);
    hn::Store(mean_1, d, means + i + out_stride);
    hn::Store(mean_2, d, means + i + 2 * out_stride);
    hn::Store(mean_3, d, means + i + 3 * out_stride);
    hn::Store(variance_0, d, variances + i);
    hn::Store(variance_1, d, variances + i + out_stride);
    hn::Store(variance_2, d, variances + i + 2 * out_stride);
    hn::Store(variance_3, d, variances + i + 3 * out_stride);
  }
}

void moments_of_row(const float* column_means, const float* column_variances, int count,
                    float* mean, float* variance) {
  const Taps<float, radius>& taps = ssim_taps();
  for (int i = 0; i < count; i += int(hn::Lanes(d))) {
    const float *means = column_means + i, *variances = column_variances + i;
    const V centre = hn::LoadU(d, means);
    V shift = hn::Zero(d), squares = shift;
    for (int k = radius; k > 0; --k) {
      const V before = hn::Sub(hn::LoadU(d, means - k), centre);
      const V after = hn::Sub(hn::LoadU(d, means + k), centre);
      const V tap = hn::Set(d, taps.at[k]);
      const V between = hn::Add(hn::Mul(before, before), hn::Mul(after, after));
      const V within = hn::Add(hn::LoadU(d, variances - k), hn::LoadU(d, variances + k));
      shift = hn::Add(shift, hn::Mul(tap, hn::Add(before, after)));
      squares = hn::Add(squares, hn::Mul(tap, hn::Add(between, within)));
    }
    squares = hn::Add(squares, hn::Mul(hn::Set(d, taps.at[0]), hn::LoadU(d, variances)));
    hn::StoreU(hn::Add(centre, shift), d, mean + i);
    hn::StoreU(hn::Sub(squares, hn::Mul(shift, shift)), d, variance + i);
  }
}

/// Fills the rows of a strip in `moments`.
void find_moments(const Image& reference, Window strip, Scratch& scratch, Rows& moments) {
  const Window inside = strip.grown(radius).clipped(reference.window());
  scratch.reset(strip, 1, reference_columns);
  auto& [planes, columns] = scratch;
  for (int c = 0; c < channels; ++c) {
    for (int y = inside.y0; y < inside.y1; ++y)
      read_reference(reference.at(inside.x0, y, c), inside.width(), planes.at(0, inside.x0, y));
    extend(planes, inside);
    for (int first = strip.y0; first < strip.y1; first += rows_at_once) {
      moments_of_columns(planes, first, columns);
      for (int y = first; y < std::min(first + rows_at_once, strip.y1); ++y)
        moments_of_row(columns.row(column_mean, y - first) + radius,
                       columns.row(column_variance, y - first) + radius, strip.width(),
                       moments.at(c, strip.x0, y), moments.at(channels + c, strip.x0, y));
    }
  }
}

/// The planes, for one channel, that are filtered to compare the images.
enum DifferencePlane { difference, squared, times_reference, difference_planes };

void read_difference(const std::uint8_t* x, const std::uint8_t* y, int count, float* differences,
                     float* squares, float* products) {
  for_each_vector(d, count, [=](auto df, int i) {
    const hn::RebindToSigned<decltype(df)> di;
    const hn::Rebind<std::uint8_t, decltype(df)> bytes;
    const auto at_y = hn::PromoteTo(di, hn::LoadU(bytes, y + i));
    const auto here = hn::ConvertTo(df, hn::Sub(hn::PromoteTo(di, hn::LoadU(bytes, x + i)), at_y));
    const auto centred = hn::ConvertTo(df, hn::Sub(at_y, hn::Set(di, byte_centre)));
    hn::StoreU(here, df, differences + i);
    hn::StoreU(hn::Mul(here, here), df, squares + i);
    hn::StoreU(hn::Mul(here, centred), df, products + i);
  });
}

/// Filters every plane down the columns, with the centres in the `rows_at_once` rows from y on.
void filter_columns(const Rows& in, int y, Rows& columns) {
  static_assert(rows_at_once == 4);
  const Taps<float, radius>& taps = ssim_taps();
  const int count = in.window().width();
  const std::ptrdiff_t stride = in.stride(), out_stride = columns.stride();
  for (int plane = 0; plane < difference_planes; ++plane) {
    const float* row = in.row(plane, y);
    float* out = columns.row(plane, 0);
    for (int i = 0; i < count; i += int(hn::Lanes(d))) {
      const V first = filter_even(d, taps, row + i, stride);
      const V second = filter_even(d, taps, row + i + stride, stride);
      const V third = filter_even(d, taps, row + i + 2 * stride, stride);
      const V fourth = filter_even(d, taps, row + i + 3 * stride, stride);
      hn::Store(first, d, out + i);
      hn::Store(second, d, out + i + out_stride);
      hn::Store(third, d, out + i + 2 * out_stride);
      hn::Store(fourth, d, out + i + 3 * out_stride);
    }
  }
}

/// Adds the distances in one channel to `distance`. The reference's moments are not in the cache,
/// so those of the next row are prefetched.
void add_distances(const Rows& columns, int row, int count, const float* mean_y,
                   const float* variance_y, std::ptrdiff_t next_row, float* distance) {
  constexpr float c1 = 6.5025F;   // (0.01 * 255)^2
  constexpr float c2 = 58.5225F;  // (0.03 * 255)^2
  const Taps<float, radius>& taps = ssim_taps();
  const float* differences = columns.row(difference, row) + radius;
  const float* squares = columns.row(squared, row) + radius;
  const float* products = columns.row(times_reference, row) + radius;
  for (int i = 0; i < count; i += int(hn::Lanes(d))) {
    const V md = filter_even(d, taps, differences + i, 1);
    const V mdd = filter_even(d, taps, squares + i, 1);
    const V myd = filter_even(d, taps, products + i, 1);
    const V my = hn::LoadU(d, mean_y + i), vy = hn::LoadU(d, variance_y + i);
    hwy::Prefetch(mean_y + next_row + i);
    hwy::Prefetch(variance_y + next_row + i);
    const V m = hn::Add(my, hn::Set(d, float(byte_centre))), mx = hn::Add(m, md);
    const V means = hn::Add(hn::Mul(m, m), hn::Mul(mx, mx));
    const V md2 = hn::Mul(md, md);
    const V p_below = hn::Add(means, hn::Set(d, c1));
    const V vd = hn::Max(hn::Zero(d), hn::Sub(mdd, md2));
    const V covariance = hn::Sub(myd, hn::Mul(my, md));
    const V half = hn::Add(vy, covariance);
    const V q_below = hn::Add(hn::Add(hn::Add(half, half), vd), hn::Set(d, c2));
    // p + q - p q with p = md2 / p_below and q = vd / q_below, in one division.
    const V above = hn::Add(hn::Mul(md2, q_below), hn::Mul(vd, hn::Sub(p_below, md2)));
    const V both = hn::Div(above, hn::Mul(p_below, q_below));
    hn::StoreU(hn::Add(hn::LoadU(d, distance + i), both), d, distance + i);
  }
}

/// Sums the distances in the three channels for the pixels of a tile.
void add_channels(const Image& test, const Image& reference, const Rows& moments, Window tile,
                  Scratch& scratch, Rows& distances) {
  distances.reset(tile, 1);
  distances.clear();
  const Window inside = tile.grown(radius).clipped(reference.window());
  scratch.reset(tile, difference_planes, difference_planes);
  auto& [planes, columns] = scratch;
  for (int c = 0; c < channels; ++c) {
    for (int y = inside.y0; y < inside.y1; ++y)
      read_difference(test.at(inside.x0, y, c), reference.at(inside.x0, y, c), inside.width(),
                      planes.at(difference, inside.x0, y), planes.at(squared, inside.x0, y),
                      planes.at(times_reference, inside.x0, y));
    extend(planes, inside);
    for (int first = tile.y0; first < tile.y1; first += rows_at_once) {
      filter_columns(planes, first, columns);
      for (int y = first; y < std::min(first + rows_at_once, tile.y1); ++y)
        add_distances(columns, y - first, tile.width(), moments.at(c, tile.x0, y),
                      moments.at(channels + c, tile.x0, y), moments.stride(), distances.row(0, y));
    }
  }
}

}  // namespace
}  // namespace gradmesh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gradmesh {
namespace {

HWY_EXPORT(find_moments);
HWY_EXPORT(add_channels);

}  // namespace

Ssim::Ssim(Image image, Weights weights) : Metric(std::move(image), radius, std::move(weights)) {
  moments_.reset(reference().window(), 2 * channels);
  for_each_strip(reference().window(), [&](Window strip) {
    HWY_DYNAMIC_DISPATCH(find_moments)(reference(), strip, per_thread<Scratch>(), moments_);
  });
}

void Ssim::score(const Image& test, Window tile, Plane& map) const {
  auto& distances = per_thread<PaddedRows<float>, struct Distances>();
  HWY_DYNAMIC_DISPATCH(add_channels)
  (test, reference(), moments_, tile, per_thread<Scratch>(), distances);
  for (int y = tile.y0; y < tile.y1; ++y) {
    const float* sums = distances.row(0, y);
    std::transform(sums, sums + tile.width(), map.at(tile.x0, y),
                   [](float sum) { return sum * (1.0F / channels); });
  }
}

}  // namespace gradmesh
#endif  // HWY_ONCE
