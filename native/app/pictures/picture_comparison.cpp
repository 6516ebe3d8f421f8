#include "app/pictures/picture_comparison.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "files/image_codec.h"
#include "metric/local_mean.h"
#include "trace/target_picture.h"

namespace gradmesh {
namespace {

Image on_white(const RgbaImage& picture) {
  Image result(picture.width, picture.height);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const auto [r, g, b, a] = picture.pixel(x, y);
      result.set_pixel(x, y, {over_white(r, a), over_white(g, a), over_white(b, a)});
    }
  return result;
}

}  // namespace

PictureComparison::PictureComparison(const RgbaImage& picture, const Affine& to_pixels,
                                     double scale, std::vector<float> counted)
    : counted_(std::move(counted)),
      pixels_(counted_.empty()
                  ? picture.pixels()
                  : std::size_t(std::ranges::count_if(counted_, [](float c) { return c != 0; }))),
      metric_(make_metric(MetricKind::flip, on_white(picture))),
      painter_(make_cairo_like_rasterizer()) {
  frame_.width = picture.width;
  frame_.height = picture.height;
  // Where pixels are larger than the document's, cairo looks less far beyond their middles.
  const double nearer = point_of_pixels(1) - point_of_pixels(scale);
  frame_.to_pixels = Affine::translation(glm::dvec2(nearer)) * to_pixels;
}

Image PictureComparison::painted(const Mesh& mesh) const {
  Image image = painter_->paint(mesh, frame_);
  const Image& picture = metric_->reference();
  for (std::size_t i = 0; i < image.samples.size(); ++i)
    if (!counts(i % image.pixels())) image.samples[i] = picture.samples[i];
  return image;
}

Plane PictureComparison::flip_map(const Image& painted) const {
  Plane map = metric_->map(painted);
  for (std::size_t i = 0; i < map.samples.size(); ++i)
    if (!counts(i)) map.samples[i] = 0;
  return map;
}

double PictureComparison::mean_of_counted(const Plane& map) const {
  return std::accumulate(map.samples.begin(), map.samples.end(), 0.0) /
         double(std::max<std::size_t>(pixels_, 1));
}

double PictureComparison::flip(const Mesh& mesh) const {
  return mean_of_counted(flip_map(painted(mesh)));
}

PictureErrors PictureComparison::errors(const Mesh& mesh) const {
  const Image painted = this->painted(mesh);
  double squares = 0, sum = 0;
  for (std::size_t i = 0; i < painted.samples.size(); ++i) {
    const double difference = double(painted.samples[i]) - metric_->reference().samples[i];
    squares += difference * difference;
    sum += std::abs(difference);
  }
  const double count = 3.0 * double(std::max<std::size_t>(pixels_, 1));
  const Plane map = flip_map(painted);
  return {std::sqrt(squares / count), sum / count, mean_of_counted(map), largest_local_mean(map)};
}

}  // namespace gradmesh
