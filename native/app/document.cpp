#include "app/document.h"

#include <cstdio>
#include <stdexcept>

#include "app/common_frames.h"
#include "app/devices.h"
#include "base/limits.h"
#include "base/utf8_path.h"
#include "files/atomic_file.h"
#include "files/zip.h"
#include "form/handles.h"
#include "form/smooth_colors.h"
#include "mesh/build.h"
#include "mesh/color_model.h"
#include "mesh/rectangle.h"
#include "mesh/subdivide.h"

namespace gradmesh {
namespace {

void check_edges(const SimplifyOptions& options) {
  const bool are_named = method_named(options.method).merges_named_edges;
  if (are_named && options.edges.empty())
    throw std::invalid_argument("the method manual needs the edges to merge.");
  if (!are_named && !options.edges.empty())
    throw std::invalid_argument("edges can be named for the method manual only.");
}

void check_saved(const SimplifyOptions& options, const AnalysisPaths& analyses) {
  if (!analyses.save.empty() && !method_named(options.method).needs_prices)
    throw std::invalid_argument("the method " + options.method +
                                " needs no analysis, so there is none to save.");
}

/// Puts the mesh into the colour model that is asked for. Returns the options. If the colour model
/// differs and the options have no original, the returned options have the mesh as it was.
RunOptions in_color_model(RunOptions options, Mesh& mesh) {
  const ColorModel model = options.color_model.value_or(mesh.color_model());
  if (model == mesh.color_model()) return options;
  if (!options.original) options.original = std::make_shared<const Mesh>(mesh);
  MeshParts parts = subdivided(mesh, 1);
  mesh = build_mesh(model == ColorModel::bilinear ? as_bilinear(std::move(parts))
                                                  : as_bicubic(std::move(parts)));
  return options;
}

/// Returns the unpacked content of bytes that gzip has compressed. Throws InputError if the content
/// would be beyond the limit on documents, and if the bytes are damaged.
std::string unpacked(std::string_view bytes, const std::string& name) {
  const std::uint64_t most = limits().document, needed = gunzipped_size(bytes);
  if (needed > most)
    throw InputError("{0} unpacks to {1} bytes, {2}.", name, needed,
                     beyond_limit("document", most, needed));
  auto text = gunzip(bytes);
  if (!text) throw InputError("{0} cannot be unpacked: it is damaged.", name);
  return std::move(*text);
}

}  // namespace

std::unique_ptr<Document> Document::read_file(const std::filesystem::path& path) {
  return parse(read_bytes(path), path.string());
}

std::unique_ptr<Document> Document::parse(std::string_view bytes, const std::string& name) {
  if (is_gzip(bytes)) {
    std::unique_ptr<Document> document = parse(unpacked(bytes, name), name);
    document->compressed_ = bytes;
    return document;
  }
  return format_of_content(bytes, utf8_path(name)).read(bytes, name);
}

Frame Document::frame(const MeshEntry& entry, const Mesh& mesh, int resolution) const {
  return naming(entry, [&] { return fit_frame(mesh, view(entry), resolution, padding()); });
}

Frame Document::seen_frame(const MeshEntry& entry, const Mesh& mesh, int resolution) const {
  Frame frame = this->frame(entry, mesh, resolution);
  if (const auto area = visible_area(entry))
    frame.hidden = std::make_shared<HiddenPixels>(*area, frame);
  return frame;
}

Image Document::render(const MeshEntry& entry, int resolution, const Rasterizer& rasterizer,
                       const Document* other) const {
  const Mesh painted = mesh(entry);
  return rasterizer.paint(painted, other ? framed_as(*other, *this, entry, resolution)
                                         : frame(entry, painted, resolution));
}

Image Document::render_like_inkscape(const MeshEntry& entry, int resolution,
                                     const Document* other) const {
  if (color_model() == ColorModel::bicubic)
    throw InputError(
        "{0}: Inkscape cannot paint its bicubic colours; gradmesh convert makes an SVG document "
        "of it.",
        name());
  return render(entry, resolution, *make_cairo_like_rasterizer(), other);
}

std::vector<MeshReport> Document::reports_of(const std::vector<SimplifiedMesh>& meshes,
                                             const std::vector<MeshEntry>& refused) {
  std::vector<MeshReport> reports;
  for (const SimplifiedMesh& m : meshes) reports.push_back({m.entry.id, m.result});
  for (const MeshEntry& entry : refused) reports.push_back({entry.id, {}, entry.refused});
  return reports;
}

std::shared_ptr<const Mesh> Document::given_original(const MeshEntry& entry) const {
  if (!originals_) return nullptr;
  const MeshEntry match = counterpart(*this, entry, *originals_, selected({}).size() == 1);
  const SeenMesh here{this, entry, mesh(entry)};
  const SeenMesh there{originals_, match, originals_->mesh(match)};
  if (format() == originals_->format() && here.view() == there.view())
    return std::make_shared<const Mesh>(there.mesh);
  // Smooth colours depend on distances in the units of their own mesh.
  MeshParts parts = subdivided(there.mesh.is_smooth() ? painted_mesh(there.mesh) : there.mesh, 1);
  transform(parts, onto(here, there));
  return std::make_shared<const Mesh>(build_derived_mesh(parts));
}

Document::Start Document::start(const MeshEntry& entry, const RunOptions& options,
                                AnalysisFiles& files) const {
  check_color_model(options);
  Start start{mesh(entry), options};
  std::shared_ptr<const Mesh>& original = start.options.original;
  if (!original) original = given_original(entry);
  if (!original) original = remembered_original(entry);
  start.options = in_color_model(start.options, start.mesh);
  start.options.view = view(entry);
  start.options.padding = padding();
  if (options.visible_only) start.options.visible = visible_area(entry);
  std::string& method = start.options.method;
  start.may_be_blocks = method == simplest && !options.has_target();
  start.options.count = what_is_counted(options, format().count);
  method = method_for(method, entry, start.mesh, *start.options.count);
  start.options.rules = rules(entry, method_named(method).keeps_rectangle);
  const PriceTableKey key = naming(entry, [&] { return analysis_key(start.mesh, start.options); });
  if (options.device_if_faster && !start.mesh.is_smooth())
    start.options.device = automatic_device(
        start.mesh, frame(entry, start.mesh, options.resolution), options.metric, options.threads);
  start.options.analysis = &files.start(key, start.mesh);
  return start;
}

std::string Document::method_for(const std::string& asked, const MeshEntry& entry, const Mesh& mesh,
                                 Count count) const {
  const bool can_be_plain = is_one_gradient(entry) && suits(method_named(plain_method), mesh);
  if (asked == simplest && can_be_plain && count == Count::handles) return plain_method;
  const bool suits_asked = asked == plain_method || method_named(asked).merges_named_edges;
  if (mesh.is_smooth() && !suits_asked) return line_method;
  return asked == simplest ? best_method : asked;
}

void Document::check_color_model(const RunOptions& options) const {
  if (options.color_model && !format().holds(*options.color_model))
    throw InputError(why_not(*options.color_model));
}

Message Document::why_not(ColorModel model) const {
  return Message("{0}: {1} cannot hold colours of the model {2}.", name_, format().label,
                 gradmesh::name(model));
}

void Document::check_start(const SimplifiedMesh& m, const RunOptions& options) const {
  if (options.has_target()) return;
  if (m.result.changed || m.result.error <= options.epsilon) return;
  // Earlier runs with a larger epsilon may have moved the mesh away from the original.
  if ((m.entry.simplified || remembers(m.entry) || originals_) && !options.original) return;
  char error[32];
  std::snprintf(error, sizeof error, "%.5f", m.result.error);
  throw InputError(
      "{0}: before anything is merged, its error in the color model {1} is {2}, above epsilon.",
      describe(m.entry), gradmesh::name(m.mesh.color_model()), error);
}

SimplifyResult Document::simplified(const MeshEntry& entry, const Start& start, Mesh& mesh) const {
  const RunOptions& options = start.options;
  SimplifyResult result = gradmesh::simplify(mesh, options);
  if (result.stopped == Stopped::cancelled || result.stopped == Stopped::budget) return result;
  const Method& method = method_named(options.method);
  if (method.makes_plain && start.may_be_blocks) return simplest_of(entry, start, result, mesh);
  const bool needs_mask = result.changed && result.form.masks_opacity();
  if (method.merges_named_edges || method.keeps_rectangle || options.has_target() ||
      !is_one_gradient(entry) || !find_grid(start.mesh) || (result.changed && !needs_mask))
    return result;
  Mesh other = start.mesh;
  const auto lines = simplified_anew(entry, start, line_method, result, other);
  const bool for_handles = options.count == Count::handles;
  const auto left = [&](const SimplifyResult& r) {
    return for_handles ? to_handle(r) : r.patches_after;
  };
  if (!lines || !lines->changed || left(*lines) > left(result)) return result;
  mesh = std::move(other);
  return *lines;
}

SimplifyResult Document::simplest_of(const MeshEntry& entry, const Start& start,
                                     SimplifyResult result, Mesh& mesh) const {
  // A group in the place of an object has to be worth it.
  constexpr double most_of_plain = 2.0 / 3;
  for (const char* method : {line_method, best_method}) {
    const bool is_simple = result.changed && 2 * result.handles_after <= result.handles_before;
    if (is_simple || !suits(method_named(method), start.mesh)) continue;
    Mesh other = start.mesh;
    const auto found = simplified_anew(entry, start, method, result, other);
    const Stopped stopped = found ? found->stopped : Stopped::budget;
    const bool is_over = stopped == Stopped::budget || stopped == Stopped::cancelled;
    // What is left untried might have been simpler.
    if (is_over && !result.changed) result.stopped = stopped;
    if (!found) break;
    const double most = method == line_method ? 1 : most_of_plain;
    if (found->changed && to_handle(*found) < most * to_handle(result)) {
      mesh = std::move(other);
      result = *found;
    } else {
      result.evaluations = found->evaluations;
      result.seconds = found->seconds;
    }
    if (is_over) break;
  }
  return result;
}

std::optional<SimplifyResult> Document::simplified_anew(const MeshEntry& entry, const Start& start,
                                                        const std::string& method,
                                                        const SimplifyResult& before,
                                                        Mesh& mesh) const {
  RunOptions options = start.options;
  options.method = method;
  options.rules = rules(entry, method_named(method).keeps_rectangle);
  if (!method_named(method).needs_prices) options.analysis = nullptr;
  if (options.time_budget > 0) {
    options.time_budget -= before.seconds.total;
    if (options.time_budget <= 0) return std::nullopt;
  }
  SimplifyResult result = gradmesh::simplify(mesh, options);
  result.evaluations += before.evaluations;
  result.seconds.select += before.seconds.total;
  result.seconds.total += before.seconds.total;
  return result;
}

std::vector<Document::SimplifiedMesh> Document::simplified(const std::vector<std::string>& ids,
                                                           const RunOptions& options,
                                                           const AnalysisPaths& analyses) const {
  check_edges(options);
  check_saved(options, analyses);
  const std::vector<MeshEntry> entries = selected(ids);
  if (method_named(options.method).merges_named_edges && entries.size() > 1)
    throw InputError("{0}: there are {1} meshes, and edges can be named of one only.", name_,
                     entries.size());

  // All meshes are read before the first run, as a run may take long.
  AnalysisFiles files(analyses);
  std::vector<Start> starts;
  for (const MeshEntry& entry : entries) starts.push_back(start(entry, options, files));
  std::vector<SimplifiedMesh> meshes;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    auto original = starts[i].options.original;
    if (!original) original = std::make_shared<const Mesh>(starts[i].mesh);
    SimplifiedMesh& m =
        meshes.emplace_back(SimplifiedMesh{entries[i], starts[i].mesh, {}, std::move(original)});
    m.result = naming(m.entry, [&] { return simplified(m.entry, starts[i], m.mesh); });
    check_start(m, options);
  }
  files.save();
  return meshes;
}

std::vector<MeshReport> Document::simplify(const std::vector<std::string>& ids,
                                           const RunOptions& options, const AnalysisPaths& analyses,
                                           const WriteOptions& writing) {
  check_writing(writing);
  std::vector<SimplifiedMesh> meshes = simplified(ids, options, analyses);
  const std::vector<MeshReport> reports = reports_of(meshes, refused(ids));
  std::erase_if(meshes, [](const SimplifiedMesh& m) { return !m.result.changed; });
  if (!meshes.empty()) {
    replace(meshes, options.metric, writing);
    changed_ = true;
  }
  return reports;
}

std::vector<MeshReport> Document::preview(const std::vector<std::string>& ids, RunOptions options,
                                          const AnalysisPaths& analyses) const {
  if (method_named(options.method).merges_named_edges) {
    options.epsilon = 1;
    options.max_local_error.reset();
  }
  return reports_of(simplified(ids, options, analyses), refused(ids));
}

std::vector<UpdateReport> Document::update(const std::vector<std::string>& ids) {
  std::vector<UpdateReport> reports = update_edited(selected(ids));
  for (const UpdateReport& report : reports) changed_ = changed_ || report.changed;
  return reports;
}

std::vector<UpdateReport> Document::update_edited(const std::vector<MeshEntry>&) {
  throw InputError("{0}: only meshes that were simplified in an SVG document can be updated.",
                   name_);
}

std::size_t Document::analyze(const std::vector<std::string>& ids, const RunOptions& options,
                              const AnalysisPaths& analyses) const {
  AnalysisFiles files(analyses);
  std::size_t prices = 0;
  for (const MeshEntry& entry : selected(ids)) {
    const Start start = this->start(entry, options, files);
    naming(entry, [&] { analyze_regions(start.mesh, start.options); });
    prices += start.options.analysis->prices.size();
  }
  files.save();
  return prices;
}

void Document::check_target(const std::filesystem::path& path) const {
  const Format* promised = format_of(path);
  if (promised && *promised != format())
    throw InputError(
        "{0} is not of the kind of {1}: gradmesh convert makes a .hemesh file of an SVG document, "
        "and the reverse.",
        name_, path.string());
}

void Document::write_file(const std::filesystem::path& path) const {
  check_target(path);
  if (path.extension().string() != format().compressed_extension)
    write_bytes(path, bytes());
  else
    write_bytes(path, changed_ || compressed_.empty() ? gzip(bytes()) : compressed_);
}

}  // namespace gradmesh
