#include "app/document/document.h"

#include "app/document/common_frames.h"
#include "app/document/folder_move.h"
#include "files/atomic_file.h"
#include "files/zip.h"
#include "form/blocks.h"
#include "form/smooth_colors.h"
#include "mesh/build.h"
#include "mesh/subdivide.h"
#include "simplify/options.h"

namespace gradmesh {

void Document::set_file(const std::filesystem::path& path) {
  look_in({path.parent_path()});
  // Now, as a program may go to another folder until it writes.
  file_ = std::filesystem::absolute(path);
}

Frame Document::frame(const MeshEntry& entry, const Mesh& mesh, int resolution) const {
  const Affine seen = view(entry);  // Names the element itself.
  return naming(entry, [&] { return fit_frame(mesh, seen, resolution, padding()); });
}

Layout Document::layout(const MeshEntry& entry, bool visible_only) const {
  return {view(entry), padding(), visible_only ? visible_area(entry) : std::nullopt};
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

std::shared_ptr<const Mesh> Document::original(const MeshEntry& entry) const {
  const std::shared_ptr<const Mesh> given = given_original(entry);
  return given ? given : remembered_original(entry);
}

void Document::check_color_model(ColorModel model) const {
  if (!format().holds(model)) throw InputError(why_not(model));
}

std::vector<FilledOutline> Document::covered(const std::vector<std::string>&) const {
  throw InputError("{0}: shapes that cover parts of a mesh are known in SVG documents only.",
                   name());
}

Message Document::why_not(ColorModel model) const {
  return Message("{0}: {1} cannot hold colours of the model {2}.", name_, format().label,
                 gradmesh::name(model));
}

void Document::write(const std::vector<ChangedMesh>& meshes, MetricKind metric,
                     const WriteOptions& writing) {
  replace(meshes, metric, writing);
  changed_ = true;
}

ChosenPatches Document::whole(const MeshEntry& entry) const {
  const auto grid = find_grid(mesh(entry));
  if (!grid) throw InputError("{0}: its mesh is not one rectangle of patches.", describe(entry));
  return {entry, *grid};
}

Rewritten Document::rewrite(const MeshEntry& entry, const Mesh& edited, MetricKind metric,
                            int resolution, bool meant_to_differ) {
  std::shared_ptr<const Mesh> against = original(entry);
  if (!against) against = std::make_shared<const Mesh>(mesh(entry));
  const auto [written, frame] = naming(entry, [&] {
    Problem problem(against, nullptr, layout(entry, true), resolution, metric);
    // A rectangle that was one mesh gradient stays one, unless its colours are sharp somewhere.
    problem.rules = rules(entry, find_grid(edited) && has_one_color_at_each_point(edited));
    return std::pair(problem.measure(edited), problem.frame());
  });
  WriteOptions writing;
  writing.remember_original = !meant_to_differ && is_to_remember(entry);
  write({{entry, written, counts_of(*against), frame, against}}, metric, writing);
  return {written.counts(), written.form.object_count(), written.error};
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

void Document::check_target(const std::filesystem::path& path) const {
  if (is_of_pages(path))
    throw InputError("{0}: such documents are only read; write an SVG document or a .hemesh file.",
                     path.string());
  const Format* promised = format_of(path);
  if (promised && *promised != format())
    throw InputError(
        "{0} is not of the kind of {1}: gradmesh convert makes a .hemesh file of an SVG document, "
        "and the reverse.",
        name_, path.string());
}

std::string Document::bytes_for(const std::filesystem::path& path) const {
  const std::optional<FolderMove> move = file_.empty() ? std::nullopt : folder_move(file_, path);
  return move ? bytes_in(*move) : bytes();
}

void Document::write_file(const std::filesystem::path& path) const {
  check_target(path);
  const std::string content = bytes_for(path);
  if (path.extension().string() != format().compressed_extension)
    write_bytes(path, content);
  else
    write_bytes(path, compressed_.empty() || content != content_ ? gzip(content) : compressed_);
}

}  // namespace gradmesh
