#include "app/trace.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <stdexcept>
#include <variant>

#include "app/formats.h"
#include "app/picture_part.h"
#include "app/svg_meshes.h"
#include "app/traced_curve.h"
#include "base/clamped_int.h"
#include "base/error.h"
#include "base/limits.h"
#include "files/picture_file.h"
#include "formats/text/excerpt.h"
#include "mesh/build.h"
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

glm::dvec2 full_size(const Picture& picture) { return {picture.full_width, picture.full_height}; }

PartOptions part_options(const TraceOptions& options) {
  return {options.handles, options.epsilon, options.detail, options.wants_curve};
}

/// Returns a document of one mesh on a page of this size, all of which its object covers.
std::string document_of(const Mesh& mesh, glm::dvec2 page, const Frame& frame) {
  const Mesh outline = build_mesh(LineGrid(1, 1, page).parts());
  const Translation english = [](const std::string& text) { return text; };
  return format_named("svg").write({mesh, outline, frame, page, english});
}

SvgMeshes& as_svg(Document& document) {
  return document.as_svg(Message("{0}: only an SVG document holds outlines.", document.name()));
}

/// Returns the picture that a document in this folder shows.
Picture shown_picture(Document& document, const std::filesystem::path& folder, int longest) {
  const ImageFile file = as_svg(document).image_file();
  if (const auto* bytes = std::get_if<std::string>(&file))
    return picture_of_bytes(*bytes, document.name(), longest);
  return read_picture(folder / std::get<std::filesystem::path>(file), longest);
}

/// Returns the window of a picture's pixels around a shape that is in pixels of its file.
Window window_around(const Outline& shape, const Picture& picture) {
  // So many more pixels each way as the metric looks at around those that count.
  constexpr int around = 8;
  const RgbaImage& image = picture.image;
  const Affine to_image =
      Affine::scaling(glm::dvec2(image.width, image.height) / full_size(picture));
  const Box box = bounding_box(mapped(shape, to_image));
  return Window{clamped_int(std::floor(box.low().x), 0, image.width),
                clamped_int(std::floor(box.low().y), 0, image.height),
                clamped_int(std::ceil(box.high().x), 0, image.width),
                clamped_int(std::ceil(box.high().y), 0, image.height)}
      .grown(around)
      .clipped(image.window());
}

/// Returns the part of a picture around a shape.
PicturePart part_around(const Picture& picture, const ShapeOnPicture& on) {
  const RgbaImage& image = picture.image;
  const Window window = window_around(on.shape.outline, picture);
  const glm::dvec2 pixel = full_size(picture) / glm::dvec2(image.width, image.height);
  const glm::dvec2 corner = pixel * glm::dvec2(window.x0, window.y0);
  PicturePart part{RgbaImage(window.width(), window.height()),
                   pixel * glm::dvec2(window.width(), window.height()),
                   on.to_mesh * Affine::translation(corner), on.scale,
                   mapped(on.shape, Affine::translation(-corner))};
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x)
      part.image.set_pixel(x - window.x0, y - window.y0, image.pixel(x, y));
  return part;
}

/// Fills in what is told of the mesh that was written into the document.
void tell(Tracing& result, TracedPart traced, const MeshEntry& entry, const PartTracer& tracer,
          const TraceOptions& options, const StopWatch& watch) {
  const Mesh& written = result.document->mesh(entry);
  result.id = entry.id;
  result.rows = traced.rows;
  result.columns = traced.columns;
  result.was_stopped = watch.reason() != StopWatch::Reason::none;
  result.counts = counts_of(written);
  result.errors = tracer.errors(written);
  result.errors_without_detail = tracer.errors_without_detail(written);
  if (options.wants_curve) {
    traced.simpler.insert(traced.simpler.begin(), written);
    result.curve = traced_curve(std::move(traced.simpler), tracer);
  }
  result.seconds = watch.seconds();
}

nlohmann::ordered_json errors_json(const PictureErrors& errors) {
  return {{"rmse", errors.rmse}, {"mean", errors.mean}, {"flip", errors.flip}};
}

}  // namespace

Tracing trace(const Picture& picture, const std::string& name, const TraceOptions& options) {
  check(options);
  const ThreadLimit limit(options.threads);
  StopWatch watch(options.time_budget, options.progress);
  const glm::dvec2 size = full_size(picture);
  const PartTracer tracer({picture.image, size, {}}, part_options(options));
  TracedPart traced = tracer.run(watch);
  const std::string content = document_of(traced.mesh, size, tracer.frame());
  Tracing result;
  result.document = format_named("svg").read(content, name);
  const MeshEntry entry = result.document->meshes().front();
  tell(result, std::move(traced), entry, tracer, options, watch);
  return result;
}

Tracing trace_shape(const Picture& picture, std::unique_ptr<Document> document,
                    const std::string& id, const TraceOptions& options) {
  check(options);
  const ThreadLimit limit(options.threads);
  StopWatch watch(options.time_budget, options.progress);
  SvgMeshes& svg = as_svg(*document);
  const PartTracer tracer(part_around(picture, svg.shape_on_picture(id, full_size(picture))),
                          part_options(options));
  if (!tracer.has_pixels())
    throw InputError("{0}: {1} does not lie on the picture.", svg.name(), excerpt(id));
  TracedPart traced = tracer.run(watch);
  const MeshEntry entry = svg.paint_shape(id, traced.mesh);
  Tracing result;
  result.document = std::move(document);
  tell(result, std::move(traced), entry, tracer, options, watch);
  return result;
}

Tracing trace_file(const std::filesystem::path& picture, int resolution, const std::string& name,
                   const TraceOptions& options) {
  check(options);
  check_resolution(resolution);
  return trace(read_picture(picture, resolution), name, options);
}

Tracing trace_file_in_shape(const std::filesystem::path& picture, int resolution,
                            const std::filesystem::path& outline, const std::string& id,
                            const TraceOptions& options) {
  check(options);
  check_resolution(resolution);
  std::unique_ptr<Document> document = Document::read_file(outline);
  const auto reduced_to = [&](int longest) {
    return picture.empty() ? shown_picture(*document, outline.parent_path(), longest)
                           : read_picture(picture, longest);
  };
  Picture read = reduced_to(resolution);
  // The shape is to have the resolution, and not the picture around it.
  const glm::dvec2 size = full_size(read);
  const glm::dvec2 shape =
      bounding_box(as_svg(*document).shape_on_picture(id, size).shape.outline).size();
  const double longest = std::max(size.x, size.y);
  const double wanted = resolution * longest / std::max({shape.x, shape.y, 1.0});
  if (wanted < resolution || longest > resolution)
    read = reduced_to(clamped_int(std::min(wanted, longest), 1, INT_MAX));
  return trace_shape(read, std::move(document), id, options);
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
