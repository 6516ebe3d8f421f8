#include "metric/appearance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "metric/colour_matrices.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "metric/appearance.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "metric/elementary-inl.h"
#include "metric/filter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gradmesh::HWY_NAMESPACE {
namespace {

using D = Lanes<float>;
using V = hn::Vec<D>;
constexpr D d;

using Rows = PaddedRows<float>;

enum Opponent { luminance, red_green, blue_yellow, opponents };
/// The results of the filters down the columns, which are the input of those along a row.
enum Column {
  y_column,
  cx_column,
  cz_wide_column,
  cz_narrow_column,
  smooth_column,
  slope_column,
  curvature_column,
  all_columns
};

HWY_INLINE V product(const Linear& matrix, int row, V p, V q, V r) {
  const auto& m = matrix.m[row];
  return hn::Add(hn::Add(hn::Mul(hn::Set(d, m[0]), p), hn::Mul(hn::Set(d, m[1]), q)),
                 hn::Mul(hn::Set(d, m[2]), r));
}

/// Reads columns [x0, x1) of row y of the image as opponent colours.
void read_row(const Image& image, const std::array<float, 256>& linear_light, int y, int x0, int x1,
              Rows& light, Rows& opponent) {
  for (int c = 0; c < 3; ++c) {
    const std::uint8_t* bytes = image.at(x0, y, c);
    float* row = light.row(c, 0);
    for (int i = 0; i < x1 - x0; ++i) row[i] = linear_light[bytes[i]];
  }
  const float *red = light.row(0, 0), *green = light.row(1, 0), *blue = light.row(2, 0);
  for (int plane = 0; plane < opponents; ++plane) {
    float* out = opponent.at(plane, x0, y);
    for (int i = 0; i < x1 - x0; i += int(hn::Lanes(d))) {
      const V r = hn::Load(d, red + i), g = hn::Load(d, green + i), b = hn::Load(d, blue + i);
      hn::StoreU(product(rgb_to_opponent, plane, r, g, b), d, out + i);
    }
  }
}

/// Returns CIELab's function f of t.
HWY_INLINE V lab_curve(V t) {
  constexpr float delta = 6 / 29.0F;
  const V knee = hn::Set(d, delta * delta * delta);
  const V root = cube_root(d, hn::Max(t, knee));
  return hn::IfThenElse(hn::Gt(t, knee), root,
                        scaled_sum(d, 1 / (3 * delta * delta), t, 4 / 29.0F));
}

HWY_INLINE V in_gamut(V sample) { return hn::Min(hn::Max(sample, hn::Zero(d)), hn::Set(d, 1.0F)); }

/// Converts filtered opponent colours to CIELab with Hunt's adjustment. Colours that the filters
/// carry out of the gamut are clamped in linear RGB first.
HWY_INLINE void perceive(V y, V cx, V cz, float* lightness, float* a, float* b) {
  const V red = in_gamut(product(opponent_to_rgb, 0, y, cx, cz));
  const V green = in_gamut(product(opponent_to_rgb, 1, y, cx, cz));
  const V blue = in_gamut(product(opponent_to_rgb, 2, y, cx, cz));
  const V fx = lab_curve(product(rgb_to_white_xyz, 0, red, green, blue));
  const V fy = lab_curve(product(rgb_to_white_xyz, 1, red, green, blue));
  const V fz = lab_curve(product(rgb_to_white_xyz, 2, red, green, blue));
  const V l = scaled_sum(d, 116, fy, -16);
  const V hunt = hn::Mul(hn::Set(d, 0.01F), l);
  hn::StoreU(l, d, lightness);
  hn::StoreU(hn::Mul(hn::Mul(hunt, hn::Set(d, 500.0F)), hn::Sub(fx, fy)), d, a);
  hn::StoreU(hn::Mul(hn::Mul(hunt, hn::Set(d, 200.0F)), hn::Sub(fy, fz)), d, b);
}

// The filters down the columns, with their centres in the row `in`.

void filter_luminance_down(const float* in, std::ptrdiff_t stride, int count, Rows& columns) {
  const Taps<float, ColourTaps::short_reach>& blur = ColourTaps::get().luminance;
  const FeatureTaps& feature = FeatureTaps::get();
  float *y = columns.row(y_column, 0), *smooth_out = columns.row(smooth_column, 0),
        *slope_out = columns.row(slope_column, 0),
        *curvature_out = columns.row(curvature_column, 0);
  for (int i = 0; i < count; i += int(hn::Lanes(d))) {
    const V centre = hn::Load(d, in + i), twice = hn::Add(centre, centre);
    V blurred = hn::Zero(d), smooth = blurred, slope = blurred, curvature = blurred;
    for (int k = FeatureTaps::reach; k > 0; --k) {
      const V above = hn::Load(d, in + i - k * stride), below = hn::Load(d, in + i + k * stride);
      if (k <= ColourTaps::short_reach) blurred = add_even(d, blurred, blur.at[k], above, below);
      smooth = add_even(d, smooth, feature.smooth.at[k], above, below);
      slope = add_odd(d, slope, feature.slope.at[k], above, below);
      curvature = add_zero_sum(d, curvature, feature.curvature.at[k], above, below, twice);
    }
    blurred = hn::Add(blurred, hn::Mul(hn::Set(d, blur.at[0]), centre));
    smooth = hn::Add(smooth, hn::Mul(hn::Set(d, feature.smooth.at[0]), centre));
    hn::Store(blurred, d, y + i);
    hn::Store(smooth, d, smooth_out + i);
    hn::Store(slope, d, slope_out + i);
    hn::Store(curvature, d, curvature_out + i);
  }
}

void filter_red_green_down(const float* in, std::ptrdiff_t stride, int count, Rows& columns) {
  const Taps<float, ColourTaps::short_reach>& blur = ColourTaps::get().red_green;
  float* cx = columns.row(cx_column, 0);
  for (int i = 0; i < count; i += int(hn::Lanes(d)))
    hn::Store(filter_even(d, blur, in + i, stride), d, cx + i);
}

void filter_blue_yellow_down(const float* in, std::ptrdiff_t stride, int count, Rows& columns) {
  const auto &wide_taps = ColourTaps::get().blue_yellow_wide,
             &narrow_taps = ColourTaps::get().blue_yellow_narrow;
  float *wide_out = columns.row(cz_wide_column, 0), *narrow_out = columns.row(cz_narrow_column, 0);
  for (int i = 0; i < count; i += int(hn::Lanes(d))) {
    V wide = hn::Zero(d), narrow = wide;
    for (int k = ColourTaps::reach; k > 0; --k) {
      const V above = hn::Load(d, in + i - k * stride), below = hn::Load(d, in + i + k * stride);
      wide = add_even(d, wide, wide_taps.at[k], above, below);
      narrow = add_even(d, narrow, narrow_taps.at[k], above, below);
    }
    const V centre = hn::Load(d, in + i);
    wide = hn::Add(wide, hn::Mul(hn::Set(d, wide_taps.at[0]), centre));
    narrow = hn::Add(narrow, hn::Mul(hn::Set(d, narrow_taps.at[0]), centre));
    hn::Store(wide, d, wide_out + i);
    hn::Store(narrow, d, narrow_out + i);
  }
}

// The filters along a row, and what follows them.

void colour_row(const Rows& columns, int count, float* lightness, float* a, float* b) {
  const auto start = [&](Column column) { return columns.row(column, 0) + appearance_reach; };
  const float *luminance_in = start(y_column), *red_green_in = start(cx_column),
              *wide_in = start(cz_wide_column), *narrow_in = start(cz_narrow_column);
  const ColourTaps& taps = ColourTaps::get();
  for (int i = 0; i < count; i += int(hn::Lanes(d))) {
    const V y = filter_even(d, taps.luminance, luminance_in + i, 1);
    const V cx = filter_even(d, taps.red_green, red_green_in + i, 1);
    const V cz = hn::Add(filter_even(d, taps.blue_yellow_wide, wide_in + i, 1),
                         filter_even(d, taps.blue_yellow_narrow, narrow_in + i, 1));
    perceive(y, cx, cz, lightness + i, a + i, b + i);
  }
}

HWY_INLINE V magnitude(V dx, V dy) { return hn::Sqrt(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy))); }

void feature_row(const Rows& columns, int count, float* edge, float* point) {
  const auto start = [&](Column column) { return columns.row(column, 0) + appearance_reach; };
  const float *smooth = start(smooth_column), *slope_in = start(slope_column),
              *curvature_in = start(curvature_column);
  const FeatureTaps& taps = FeatureTaps::get();
  for (int i = 0; i < count; i += int(hn::Lanes(d))) {
    const V centre = hn::LoadU(d, smooth + i), twice = hn::Add(centre, centre);
    V slope = hn::Zero(d), curvature = slope;
    for (int k = FeatureTaps::reach; k > 0; --k) {
      const V before = hn::LoadU(d, smooth + i - k), after = hn::LoadU(d, smooth + i + k);
      slope = add_odd(d, slope, taps.slope.at[k], before, after);
      curvature = add_zero_sum(d, curvature, taps.curvature.at[k], before, after, twice);
    }
    hn::StoreU(magnitude(slope, filter_even(d, taps.smooth, slope_in + i, 1)), d, edge + i);
    hn::StoreU(magnitude(curvature, filter_even(d, taps.smooth, curvature_in + i, 1)), d,
               point + i);
  }
}

void find_row(const Rows& opponent, int y, Rows& columns, const AppearanceRow<float>& out) {
  const int width = opponent.window().width(), count = width - 2 * appearance_reach;
  filter_luminance_down(opponent.row(luminance, y), opponent.stride(), width, columns);
  filter_red_green_down(opponent.row(red_green, y), opponent.stride(), width, columns);
  filter_blue_yellow_down(opponent.row(blue_yellow, y), opponent.stride(), width, columns);
  colour_row(columns, count, out.lightness, out.a, out.b);
  feature_row(columns, count, out.edge, out.point);
}

}  // namespace
}  // namespace gradmesh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gradmesh {
namespace {

HWY_EXPORT(read_row);
HWY_EXPORT(find_row);

}  // namespace

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

void AppearanceFilter::read(const Image& image, Window frame, Window box) {
  const Window around = box.grown(appearance_reach), inside = around.clipped(frame);
  const Window one_row = {around.x0, 0, around.x1, 1};
  opponent_.reset(around, HWY_NAMESPACE::opponents);
  light_.reset(one_row, 3);
  columns_.reset(one_row, HWY_NAMESPACE::all_columns);
  const auto read_one = HWY_DYNAMIC_DISPATCH(read_row);
  for (int y = inside.y0; y < inside.y1; ++y)
    read_one(image, linear_light(), y, inside.x0, inside.x1, light_, opponent_);
  extend(opponent_, inside);
}

void AppearanceFilter::row(int y, const AppearanceRow<float>& out) {
  HWY_DYNAMIC_DISPATCH(find_row)(opponent_, y, columns_, out);
}

}  // namespace gradmesh
#endif  // HWY_ONCE
