#include "app/trace.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/formats.h"
#include "base/clamped_int.h"
#include "base/error.h"
#include "base/limits.h"
#include "files/box_reducer.h"
#include "files/image_codec.h"
#include "files/picture_file.h"
#include "mesh/build.h"
#include "raster/rasterizer.h"
#include "trace/traced_grid.h"

namespace gradmesh {
namespace {

void check(const TraceOptions& options) {
  constexpr double most = 1e5;
  if (!(options.handles >= 4 && options.handles <= most))
    throw std::invalid_argument("a mesh has 4 to 100000 handles.");
  if (!(options.epsilon >= 0 && options.epsilon <= 1))
    throw std::invalid_argument("epsilon must be between 0 and 1.");
  if (!(options.detail >= 1 && options.detail <= most))
    throw std::invalid_argument("detail must be between 1 and 100000 pixels.");
  const std::uint64_t patches = limits().patches, handles = std::uint64_t(options.handles);
  if (handles > patches)
    throw InputError("{0} handles can be as many patches, {1}.", options.handles,
                     beyond_limit("patches", patches, handles));
}

Image on_white(const RgbaImage& picture) {
  Image result(picture.width, picture.height);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const auto [r, g, b, a] = picture.pixel(x, y);
      result.set_pixel(x, y, {over_white(r, a), over_white(g, a), over_white(b, a)});
    }
  return result;
}

/// A picture that meshes over (0, 0) to the page's size are compared with.
class Comparison {
 public:
  Comparison(const RgbaImage& picture, glm::dvec2 page)
      : metric_(make_metric(MetricKind::flip, on_white(picture))),
        // Where a page is painted smaller than it is, cairo's way to sample says nothing of what a
        // person sees.
        painter_(page == glm::dvec2(picture.width, picture.height) ? make_cairo_like_rasterizer()
                                                                   : make_software_rasterizer()) {
    frame_.width = picture.width;
    frame_.height = picture.height;
    frame_.to_pixels = Affine::scaling(glm::dvec2(picture.width, picture.height) / page);
  }

  const Frame& frame() const { return frame_; }
  double flip(const Mesh& mesh) const { return mean(metric_->map(painter_->paint(mesh, frame_))); }

  PictureErrors errors(const Mesh& mesh) const {
    const Image painted = painter_->paint(mesh, frame_);
    double squares = 0, sum = 0;
    for (std::size_t i = 0; i < painted.samples.size(); ++i) {
      const double difference = double(painted.samples[i]) - metric_->reference().samples[i];
      squares += difference * difference;
      sum += std::abs(difference);
    }
    const auto count = double(painted.samples.size());
    return {std::sqrt(squares / count), sum / count, mean(metric_->map(painted))};
  }

 private:
  const std::unique_ptr<Metric> metric_;
  const std::unique_ptr<Rasterizer> painter_;
  Frame frame_;
};

/// Returns the picture without what is smaller than `detail` pixels of the page.
RgbaImage without_detail(const RgbaImage& picture, glm::dvec2 page, double detail) {
  const int longest = std::max(picture.width, picture.height);
  const double wanted = std::max(page.x, page.y) / detail;
  if (wanted >= longest) return picture;
  BoxReducer reducer(picture.width, picture.height, clamped_int(wanted + 0.5, 1, longest));
  std::vector<std::uint16_t> row(4 * std::size_t(picture.width));
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x)
      for (int k = 0; k < 4; ++k)
        row[std::size_t(4 * x + k)] = std::uint16_t(257 * *picture.at(x, y, k));
    reducer.add_row(row.data());
  }
  return reducer.image();
}

/// Returns a narrow picture with each pixel repeated, so that a mesh has the colour of a pixel all
/// over it, and not only where it is looked at.
RgbaImage with_wide_pixels(const RgbaImage& picture) {
  constexpr int narrow = 8;
  const int times = (narrow + std::min(picture.width, picture.height) - 1) /
                    std::min(picture.width, picture.height);
  if (times == 1) return picture;
  RgbaImage wide(times * picture.width, times * picture.height);
  for (int y = 0; y < wide.height; ++y)
    for (int x = 0; x < wide.width; ++x) wide.set_pixel(x, y, picture.pixel(x / times, y / times));
  return wide;
}

std::string document_of(const Mesh& mesh, const Mesh& outline, const Frame& frame,
                        glm::dvec2 page) {
  const Translation english = [](const std::string& text) { return text; };
  return format_named("svg").write({mesh, outline, frame, page, english});
}

nlohmann::ordered_json errors_json(const PictureErrors& errors) {
  return {{"rmse", errors.rmse}, {"mean", errors.mean}, {"flip", errors.flip}};
}

}  // namespace

Tracing trace(const RgbaImage& picture, glm::dvec2 size, const std::string& name,
              const TraceOptions& options) {
  check(options);
  const ThreadLimit limit(options.threads);
  StopWatch watch(options.time_budget, options.progress);
  const RgbaImage followed = without_detail(picture, size, options.detail);
  const Comparison exact(picture, size), coarse(followed, size);
  const GridOptions grid_options{options.handles, [&](const LineGrid& grid) {
                                   return coarse.flip(build_mesh(grid.parts())) <= options.epsilon;
                                 }};
  const RgbaImage fitted = with_wide_pixels(followed);
  const LineGrid grid =
      traced_grid(target_of(fitted, size.x / fitted.width), size, grid_options, watch);

  Tracing result;
  result.rows = grid.rows();
  result.columns = grid.columns();
  result.was_stopped = watch.reason() != StopWatch::Reason::none;
  const Mesh mesh = build_mesh(grid.parts()), outline = build_mesh(LineGrid(1, 1, size).parts());
  result.document = format_named("svg").read(document_of(mesh, outline, exact.frame(), size), name);
  const Mesh& written = result.document->mesh(result.document->meshes().front());
  result.counts = counts_of(written);
  result.errors = exact.errors(written);
  result.errors_without_detail = coarse.errors(written);
  result.seconds = watch.seconds();
  return result;
}

Tracing trace_file(const std::filesystem::path& picture, int resolution, const std::string& name,
                   const TraceOptions& options) {
  check(options);
  check_resolution(resolution);
  const Picture read = read_picture(picture, resolution);
  return trace(read.image, {read.full_width, read.full_height}, name, options);
}

nlohmann::ordered_json tracing_json(const Tracing& tracing) {
  return {{"handles", tracing.counts.handles},
          {"patches", tracing.counts.patches},
          {"rows", tracing.rows},
          {"columns", tracing.columns},
          {"errors", errors_json(tracing.errors)},
          {"errors_without_detail", errors_json(tracing.errors_without_detail)},
          {"stopped", tracing.was_stopped},
          {"seconds", tracing.seconds}};
}

std::optional<Message> what_would_help(const Tracing& tracing) {
  constexpr double seen_at_once = 0.05;
  if (tracing.errors_without_detail.flip <= seen_at_once) return {};
  return Message(
      "with {0} handles the mesh is still {1} of 255 levels off in the mean, which is seen. More "
      "handles help, a part of the picture with soft colours, or a larger --detail; sharp shapes, "
      "text and leaves are better made by Inkscape's Trace Bitmap.",
      tracing.counts.handles, std::to_string(std::lround(tracing.errors.mean)));
}

}  // namespace gradmesh
