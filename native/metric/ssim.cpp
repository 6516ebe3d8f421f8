#include "metric/ssim.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "metric/filter.h"
#include "metric/window_plane.h"

// With d = test - reference, m and v the Gaussian mean and variance, x the test and y the
// reference, the two factors of SSIM are
//   luminance  (2 m(x) m(y) + C1) / (m(x)^2 + m(y)^2 + C1) = 1 - m(d)^2 / (m(x)^2 + m(y)^2 + C1)
//   structure  (2 cov(x, y) + C2) / (v(x) + v(y) + C2)     = 1 - v(d) / (v(x) + v(y) + C2)
// so that 1 - SSIM = p + q - p q with the two fractions on the right. This loses nothing to
// cancellation where the images are close, and is exactly 0 where they are equal. The sum of the
// variances is 2 v(y) + 2 cov(y, d) + v(d), which leaves only filters over d for each test.

namespace gradmesh {
namespace {

constexpr int radius = 5;
constexpr int channels = 3;
constexpr float c1 = 6.5025F;   // (0.01 * 255)^2
constexpr float c2 = 58.5225F;  // (0.03 * 255)^2
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

/// Filters one row of an interleaved plane after the other.
template <class T>
class Blur {
 public:
  explicit Blur(int width) : column_((width + 2 * radius) * channels) {}

  /// Writes `width` columns of row y from x on; `in` reaches `radius` pixels further.
  void operator()(const WindowPlane<T>& in, int y, int x, int width, T* out) {
    const std::ptrdiff_t margin = radius * channels, count = width * channels;
    filter_even_unit_sum(gaussian<T>(), in.at(x - radius, y), in.stride(), count + 2 * margin,
                         column_.data());
    filter_even_unit_sum(gaussian<T>(), column_.data() + margin, channels, count, out);
  }

 private:
  std::vector<T> column_;
};

}  // namespace

Ssim::Ssim(Image image)
    : LocalMetric(std::move(image), radius),
      mean_(channels * reference().width, reference().height),
      variance_(channels * reference().width, reference().height) {
  const Window frame = reference().window();
  constexpr int strip_height = 32;
  parallel_for((frame.height() + strip_height - 1) / strip_height, [&](std::size_t strip) {
    const int y0 = int(strip) * strip_height, y1 = std::min(y0 + strip_height, frame.y1);
    const Window around = Window{0, y0, frame.x1, y1}.grown(radius);
    WindowPlane<double> value(around, channels), square(around, channels);
    for_each_extended(around, frame, [&](int x, int y, int source_x, int source_y) {
      for (int c = 0; c < channels; ++c) {
        const double centred = *reference().at(source_x, source_y, c) - byte_centre;
        value.at(x, y)[c] = centred;
        square.at(x, y)[c] = centred * centred;
      }
    });
    Blur<double> blur(frame.width());
    std::vector<double> mean(frame.width() * channels), mean_square(mean.size());
    for (int y = y0; y < y1; ++y) {
      blur(value, y, 0, frame.x1, mean.data());
      blur(square, y, 0, frame.x1, mean_square.data());
      for (std::size_t i = 0; i < mean.size(); ++i) {
        mean_.at(0, y)[i] = float(mean[i]);
        variance_.at(0, y)[i] = float(mean_square[i] - mean[i] * mean[i]);
      }
    }
  });
}

void Ssim::score(const Image& test, Window tile, Plane& map) const {
  const Window around = tile.grown(radius);
  WindowPlane<float> difference(around, channels), square(around, channels),
      product(around, channels);
  for_each_extended(around, reference().window(), [&](int x, int y, int source_x, int source_y) {
    const auto b = test.pixel(source_x, source_y), a = reference().pixel(source_x, source_y);
    for (int c = 0; c < channels; ++c) {
      const int d = b[c] - a[c];
      difference.at(x, y)[c] = float(d);
      square.at(x, y)[c] = float(d * d);
      product.at(x, y)[c] = float(d * (a[c] - byte_centre));
    }
  });

  const int width = tile.width();
  Blur<float> blur(width);
  std::vector<float> mean_d(width * channels), mean_dd(mean_d), mean_yd(mean_d), distance(mean_d);
  for (int y = tile.y0; y < tile.y1; ++y) {
    blur(difference, y, tile.x0, width, mean_d.data());
    blur(square, y, tile.x0, width, mean_dd.data());
    blur(product, y, tile.x0, width, mean_yd.data());
    const float* mean_y = mean_.at(channels * tile.x0, y);
    const float* variance_y = variance_.at(channels * tile.x0, y);
    for (int i = 0; i < width * channels; ++i) {
      const float m = mean_y[i] + byte_centre, md = mean_d[i], mx = m + md;
      const float luminance = md * md / (m * m + mx * mx + c1);
      const float variance_d = std::max(0.0F, mean_dd[i] - md * md);
      const float covariance = mean_yd[i] - mean_y[i] * md;
      const float structure = variance_d / (2 * (variance_y[i] + covariance) + variance_d + c2);
      distance[i] = luminance + structure - luminance * structure;
    }
    float* out = map.at(tile.x0, y);
    for (int x = 0; x < width; ++x) {
      const float* pixel = &distance[x * channels];
      out[x] = (pixel[0] + pixel[1] + pixel[2]) * (1.0F / channels);
    }
  }
}

}  // namespace gradmesh
