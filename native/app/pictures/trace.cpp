#include "app/pictures/trace.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <variant>

#include "app/document/document_picture.h"
#include "app/document/formats.h"
#include "app/document/svg_document.h"
#include "app/pages/read_document.h"
#include "app/pictures/part_tracer.h"
#include "base/clamped_int.h"
#include "base/error.h"
#include "base/limits.h"
#include "files/picture_file.h"
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

PartOptions part_options(const TraceOptions& options) {
  return {options.handles, options.epsilon, options.detail, options.wants_curve, options.show};
}

/// Returns a document of one mesh on a page of this size, all of which its object covers.
std::string document_of(const Mesh& mesh, glm::dvec2 page, const Frame& frame) {
  const Mesh outline = build_mesh(LineGrid(1, 1, page).parts());
  const Translation english = [](const std::string& text) { return text; };
  return format_named("svg").write({mesh, outline, frame, page, english});
}

SvgDocument& as_svg(Document& document) {
  return gradmesh::as_svg(document,
                          Message("{0}: only an SVG document holds outlines.", document.name()));
}

/// Returns the curve of meshes of one gradient, each with fewer handles than the one before. Errors
/// are those against the picture without what is smaller than the detail, as of
/// TraceOptions::epsilon. An amount's mark is at the last state that is within its
/// Amount::traced_epsilon; none where no state is.
StateCurve traced_curve(std::vector<Mesh> meshes, const PartTracer& tracer) {
  StateCurve curve;
  for (Mesh& mesh : meshes) {
    const PictureErrors errors = tracer.errors_without_detail(mesh);
    CurveState& state = curve.states.emplace_back();
    state.counts = counts_of(mesh);
    state.error = errors.flip;
    state.local_error = errors.local_flip;
    state.mesh = std::make_shared<const Mesh>(std::move(mesh));
  }
  for (const Amount& amount : all_amounts())
    for (std::size_t n = curve.states.size(); n-- > 0;)
      if (curve.states[n].error <= amount.traced_epsilon) {
        curve.marks.push_back({amount.name, int(n)});
        break;
      }
  return curve;
}

/// Returns what is told of the mesh that was written into the document.
Tracing told(const Document& document, const MeshEntry& entry, TracedPart traced,
             const PartTracer& tracer, const TraceOptions& options, const StopWatch& watch) {
  const Mesh& written = document.mesh(entry);
  Tracing result;
  result.id = entry.id;
  result.rows = traced.rows;
  result.columns = traced.columns;
  result.unused_guides = traced.unused_guides.size();
  result.was_stopped = watch.reason() != StopWatch::Reason::none;
  result.counts = counts_of(written);
  result.errors = tracer.errors(written);
  result.errors_without_detail =
      tracer.leaves_detail_out() ? tracer.errors_without_detail(written) : result.errors;
  if (options.wants_curve) {
    traced.simpler.insert(traced.simpler.begin(), written);
    result.curve = traced_curve(std::move(traced.simpler), tracer);
  }
  result.seconds = watch.seconds();
  return result;
}

PicturePart part_for(const SvgDocument& svg, const std::string& id, const std::string& image,
                     const Picture& picture, const TraceOptions& options) {
  const ShapeOnPicture on = svg.shape_on_picture(id, image, options.guides, full_size(picture));
  return part_around(picture, on, weighted_shapes(svg, options.weights, on.from_document));
}

/// The trace of one shape of a document, or of an image as a whole.
class ShapeTrace {
 public:
  ShapeTrace(const SvgDocument& svg, const std::string& id, const std::string& image,
             const Picture& picture, const TraceOptions& options)
      : id_(id),
        image_(image),
        size_(full_size(picture)),
        options_(options),
        watch_(options.time_budget, options.progress),
        tracer_(part_for(svg, id, image, picture, options), part_options(options)) {
    if (!tracer_.has_pixels())
      throw InputError("{0}: {1} does not lie on the picture.", svg.name(), svg.called(id));
  }

  /// Returns false if the caller has cancelled it.
  bool run() {
    traced_ = tracer_.run(watch_);
    seconds_ = watch_.seconds();
    return watch_.reason() != StopWatch::Reason::cancelled;
  }

  /// Writes the mesh, whose object remembers the picture if that is one that the document shows.
  Tracing write(SvgDocument& svg, const DocumentPicture* shown) {
    const std::string image = shown ? svg.named_image(id_, image_) : "";
    const std::string shape = svg.is_image(id_) ? svg.cover_image(id_, size_) : id_;
    MeshEntry entry = svg.paint_shape(shape, traced_->mesh);
    if (shown) entry = svg.remember_picture(entry, {shown->hash(), {}, image}, size_);
    Tracing tracing = told(svg, entry, *std::move(traced_), tracer_, options_, watch_);
    // The others that are traced beside it have gone on since.
    tracing.seconds = seconds_;
    tracing.image = image;
    return tracing;
  }

 private:
  const std::string id_, image_;
  const glm::dvec2 size_;
  const TraceOptions options_;
  StopWatch watch_;
  const PartTracer tracer_;
  std::optional<TracedPart> traced_;
  double seconds_ = 0;
};

/// Returns options whose progress is that of one of several meshes.
TraceOptions for_one_of(TraceOptions options, std::size_t mesh, std::size_t meshes) {
  if (options.progress)
    options.progress = [tell = options.progress, mesh, meshes](Progress now) {
      now.mesh = mesh;
      now.meshes = meshes;
      return tell(now);
    };
  return options;
}

}  // namespace

TracedDocument trace(const Picture& picture, const std::string& name, const TraceOptions& options) {
  check(options);
  const ThreadLimit limit(options.threads);
  StopWatch watch(options.time_budget, options.progress);
  const glm::dvec2 size = full_size(picture);
  const PartTracer tracer({picture.image, size, {}}, part_options(options));
  TracedPart traced = tracer.run(watch);
  const std::string content = document_of(traced.mesh, size, tracer.frame());
  std::unique_ptr<Document> document = format_named("svg").read(content, name);
  const MeshEntry entry = document->meshes().front();
  Tracing tracing = told(*document, entry, std::move(traced), tracer, options, watch);
  return {std::move(document), std::move(tracing)};
}

TracedDocument trace_file(const std::filesystem::path& picture, int resolution,
                          const std::string& name, const TraceOptions& options) {
  check(options);
  check_resolution(resolution);
  return trace(read_picture(picture, resolution), name, options);
}

TracedDocument trace_file_in_shape(const std::filesystem::path& picture, int resolution,
                                   const std::filesystem::path& outline, const std::string& id,
                                   const TraceOptions& options) {
  check(options);
  check_resolution(resolution);
  const ThreadLimit limit(options.threads);
  std::unique_ptr<Document> document = read_document(outline);
  SvgDocument& svg = as_svg(*document);
  std::optional<DocumentPicture> shown;
  if (picture.empty()) shown.emplace(svg, id, "");
  const auto read = [&](int longest) {
    return shown ? shown->read(longest) : read_picture(picture, longest);
  };
  ShapeTrace shape(svg, id, "", picture_for(svg, id, "", resolution, read), options);
  shape.run();
  Tracing tracing = shape.write(svg, shown ? &*shown : nullptr);
  return {std::move(document), std::move(tracing)};
}

std::vector<Tracing> trace_in(Document& document, const ToTrace& what, int resolution,
                              const TraceOptions& options) {
  check(options);
  check_resolution(resolution);
  const ThreadLimit limit(options.threads);
  SvgDocument& svg = as_svg(document);
  // All are looked at before the first is changed.
  std::vector<DocumentPicture> pictures;
  std::vector<std::unique_ptr<ShapeTrace>> shapes;
  for (const std::string& id : what.ids) {
    const DocumentPicture& shown = pictures.emplace_back(svg, id, what.image);
    const Picture picture = picture_for(svg, id, what.image, resolution,
                                        [&](int longest) { return shown.read(longest); });
    shapes.push_back(std::make_unique<ShapeTrace>(
        svg, id, what.image, picture, for_one_of(options, shapes.size(), what.ids.size())));
    if (!shapes.back()->run()) break;
  }
  std::vector<Tracing> tracings;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    tracings.push_back(shapes[i]->write(svg, &pictures[i]));
  return tracings;
}

std::optional<Message> what_would_help(const Tracing& tracing) {
  // Levels. Meshes with less looked like their pictures, however much texture they left out; what
  // was no gradient was off by 8 and more.
  constexpr double seen_at_once = 6;
  if (tracing.errors_without_detail.mean <= seen_at_once) return {};
  return Message(
      "with {0} handles the mesh is still {1} of 255 levels off in the mean, and you can see that. "
      "Ask for more handles, choose a part of the picture with soft colours, or a larger detail. "
      "For sharp shapes, text and leaves use Inkscape's Trace Bitmap.",
      tracing.counts.handles, std::to_string(std::lround(tracing.errors.mean)));
}

}  // namespace gradmesh
