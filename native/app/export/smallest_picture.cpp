#include "app/export/smallest_picture.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "metric/local_mean.h"
#include "metric/metric.h"
#include "raster/enlarge.h"

namespace gradmesh {
namespace {

/// Colours that opacities multiply are rounded more often.
constexpr double largest_error = 0.01, largest_translucent_error = 0.015;
constexpr double largest_local_error = 0.03;
/// The fewest rows that are measured together: strips bound the memory.
constexpr int strip_height = 8 * local_side;

struct Size {
  int width, height;
};

/// Returns the sizes that are tried, from half of a picture's down in steps of a twelfth.
std::vector<Size> smaller_sizes(Size whole) {
  std::vector<Size> sizes;
  for (int width = (whole.width + 1) / 2;; width -= (width + 11) / 12) {
    const auto height = int((std::int64_t(whole.height) * width + whole.width - 1) / whole.width);
    if (std::min(width, height) < 2) return sizes;
    sizes.push_back({width, height});
  }
}

/// Return what is seen of pixels over black and over white.
std::vector<Image> over_grounds(const Image& picture) { return {picture}; }
std::vector<Image> over_grounds(const RgbaImage& multiplied) {
  Image black(multiplied.window());
  std::copy_n(multiplied.samples.begin(), black.samples.size(), black.samples.begin());
  Image white = black;
  for (std::size_t i = 0; i < white.samples.size(); ++i) {
    const int opacity = multiplied.samples[3 * white.pixels() + i % white.pixels()];
    white.samples[i] = std::uint8_t(std::min(255, white.samples[i] + 255 - opacity));
  }
  return {std::move(black), std::move(white)};
}

/// Finds the smallest picture among those of the sizes that are tried.
template <int Channels>
class Search {
 public:
  using Picture = Raster<std::uint8_t, Channels>;

  Search(const Picture& exact, const Raster<std::uint8_t, 1>& seen)
      : exact_(exact),
        seen_(seen),
        seen_pixels_(std::accumulate(seen.samples.begin(), seen.samples.end(), std::size_t(0))) {}

  /// Returns the smallest picture that is near enough; nothing if the first size is too small.
  std::optional<Picture> smallest() const {
    const std::vector<Size> sizes = smaller_sizes({exact_.width, exact_.height});
    std::optional<Picture> found;
    // Sizes before `begin` are near enough, those from `end` on are not.
    std::size_t begin = 0, end = sizes.size();
    while (begin < end) {
      const std::size_t middle = (begin + end) / 2;
      Picture tried = reduced(exact_, sizes[middle].width, sizes[middle].height);
      if (is_near(multiplied(tried))) {
        found = std::move(tried);
        begin = middle + 1;
      } else {
        end = middle;
      }
    }
    return found;
  }

 private:
  /// Returns true if a picture, multiplied(), is within the bounds.
  bool is_near(const Picture& tried) const {
    const double largest = Channels == 4 ? largest_translucent_error : largest_error;
    const int strips = std::max(1, exact_.height / strip_height);
    const auto begin = [&](int strip) { return int(std::int64_t(exact_.height) * strip / strips); };
    double sum_of_all = 0;
    for (int i = 0; i < strips; ++i) {
      const Window rows{0, begin(i), exact_.width, begin(i + 1)};
      const auto error = strip_error(tried, rows);
      if (!error) return false;
      sum_of_all += *error;
      if (sum_of_all > largest * double(seen_pixels_)) return false;
    }
    return true;
  }

  /// Returns the sum of the errors of these rows, pixels that are not seen having none; nothing if
  /// a local error is too large.
  std::optional<double> strip_error(const Picture& tried, Window rows) const {
    const Window whole{0, 0, rows.width(), rows.height()};
    const auto at_top = [&](Picture picture) {
      picture.y0 = 0;
      return picture;
    };
    Picture exact(rows);
    copy(exact_, rows, exact);
    exact = multiplied(std::move(exact));
    Picture shown = enlarged(tried, exact_.width, exact_.height, rows);
    for (int y = rows.y0; y < rows.y1; ++y)
      for (int x = 0; x < rows.x1; ++x)
        if (!*seen_.at(x, y)) shown.set_pixel(x, y, exact.pixel(x, y));
    const std::vector<Image> references = over_grounds(at_top(std::move(exact)));
    const std::vector<Image> tests = over_grounds(at_top(std::move(shown)));
    double largest = 0;
    for (std::size_t i = 0; i < references.size(); ++i) {
      const Plane map = make_metric(MetricKind::flip, references[i])->map(tests[i]);
      if (largest_local_mean(map) > largest_local_error) return std::nullopt;
      largest = std::max(largest, sum(map, whole));
    }
    return largest;
  }

  const Picture& exact_;
  const Raster<std::uint8_t, 1>& seen_;
  std::size_t seen_pixels_;
};

}  // namespace

AnyImage any_image(RgbaImage picture, bool is_opaque) {
  if (!is_opaque) return picture;
  Image image(picture.width, picture.height);
  std::copy_n(picture.samples.begin(), image.samples.size(), image.samples.begin());
  return image;
}

AnyImage smallest_picture(AnyImage exact, const Raster<std::uint8_t, 1>& seen) {
  return std::visit(
      [&](auto& picture) -> AnyImage {
        if (auto found = Search(picture, seen).smallest()) return *std::move(found);
        return std::move(picture);
      },
      exact);
}

}  // namespace gradmesh
