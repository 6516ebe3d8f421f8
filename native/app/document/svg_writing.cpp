#include "app/document/svg_document.h"

#include <algorithm>
#include <utility>

#include "app/document/document_picture.h"
#include "app/document/frames.h"
#include "app/document/mesh_label.h"
#include "app/document/svg_rules.h"
#include "formats/svg/gradient/mesh_gradient.h"
#include "formats/svg/gradient/paint_shape.h"
#include "formats/svg/gradient/user_units.h"
#include "formats/svg/gradient/written_gradient.h"
#include "formats/svg/group/memory.h"
#include "formats/svg/group/mesh_group.h"
#include "formats/svg/group/new_svg.h"
#include "formats/svg/group/shape.h"
#include "formats/svg/group/write_group.h"
#include "formats/svg/group/written_label.h"
#include "formats/svg/picture/image_cover.h"
#include "formats/svg/picture/remove_meshes.h"
#include "formats/svg/tree/kept.h"
#include "formats/svg/tree/move_links.h"
#include "formats/svg/values/mesh_outline.h"
#include "mesh/build.h"
#include "mesh/rectangle.h"
#include "mesh/subdivide.h"
#include "raster/overlaps.h"
#include "simplify/options.h"
#include "trial/measured_surface.h"

namespace gradmesh {
namespace {

/// Returns all overlaps, also those at hidden pixels, since what is hidden now may be seen later.
std::vector<Overlap> all_overlaps(const Mesh& mesh, Frame frame) {
  frame.hidden = nullptr;
  return find_overlaps(mesh, frame);
}

}  // namespace

SvgTree& SvgDocument::changing() {
  text_.reset();
  return svg_;
}

const std::string& SvgDocument::text() const {
  if (!text_) text_ = svg_.serialize();
  return *text_;
}

std::string SvgDocument::bytes_over(std::string_view shown) const {
  const std::string content = bytes();
  SvgTree tree = SvgTree::parse(content, name());
  return use_user_units(tree, SvgTree::parse(shown, name())) ? tree.serialize() : content;
}

std::string SvgDocument::bytes_in(const FolderMove& move) const {
  SvgTree tree = svg_.copy();
  return move_links(tree, move) ? tree.serialize() : bytes();
}

std::string SvgDocument::write_new(const NewDocument& document) {
  const auto& [mesh, original, frame, page, translation] = document;
  const WrittenForm form = exact_block_rules()->form(mesh, frame);
  const MeshCounts counts = counts_of(form.surface);
  const std::string label = mesh_label(counts).in(translation);
  NewSvg svg({{page.x, page.y}});
  svg.add(0, {"mesh", {covering_path(original)}, {}, {mesh, *form.blocks, label, counts}});
  return svg.tree().serialize();
}

void SvgDocument::check_conversion(const Format& to) const {
  if (to == format()) throw InputError("{0} is an SVG document already.", name());
}

Message SvgDocument::why_not(ColorModel) const {
  return Message(
      "{0}: an SVG document cannot hold bicubic colours; gradmesh convert makes a .hemesh file "
      "of it, which can.",
      name());
}

std::string SvgDocument::cover_image(const std::string& id, glm::dvec2 pixels) {
  return gradmesh::cover_image(changing(), id, pixels);
}

MeshEntry SvgDocument::paint_shape(const std::string& id, const Mesh& mesh) {
  const Frame frame = fit_frame(mesh, user_to_document(svg_, id), usual_resolution);
  gradmesh::paint_shape(changing(), id, mesh, coons_tolerance(frame));
  mark_changed();
  list_meshes();
  return selected({id}).front();
}

void SvgDocument::add_pages(const std::vector<SvgPage>& pages, const std::string& into,
                            const FillPages& fill) {
  PagesInSvg places(changing(), pages, into);
  fill(places, flat_tiles(svg_));
  mark_changed();
  list_meshes();
}

std::string SvgDocument::named_image(const std::string& id, const std::string& image) {
  return gradmesh::named_image(changing(), id, image);
}

MeshEntry SvgDocument::remember_picture(const MeshEntry& entry, RememberedPicture picture,
                                        glm::dvec2 pixels) {
  picture.to_mesh = picture_to_mesh(entry, picture.image, pixels);
  const double tolerance = coons_tolerance(frame_of(*this, entry, mesh(entry), usual_resolution));
  gradmesh::remember_picture(object(entry), picture);
  remember_original(changing(), object(entry), mesh(entry), tolerance, "");
  list_meshes({entry});
  return selected({entry.id}).front();
}

std::shared_ptr<const WritingRules> SvgDocument::rules(const MeshEntry& entry,
                                                       bool stays_one) const {
  if (!stays_one || !is_one_gradient(entry)) return block_rules();
  return gradient_rules(mesh_to_gradient(svg_, object(entry)));
}

void SvgDocument::replace(const std::vector<ChangedMesh>& meshes, MetricKind metric,
                          const WriteOptions& writing) {
  if (writing.keep_original)
    for (const ChangedMesh& m : meshes) keep_hidden_copy(changing(), object(m.entry));
  GradientsByOrigin by_origin;
  for (const ChangedMesh& m : meshes) {
    const auto& [entry, written, counts, frame, measured] = m;
    const std::string original = writing.remember_original ? new_memory(m) : "";
    const MeshObject& o = object(entry);
    const MeshCounts now{written.counts().handles, written.mesh.face_count()};
    const bool had_label = take_label(o);
    if (!written.form.blocks) {
      replace_gradient(m, original, by_origin);
      if (had_label) give_written_label(o.node, mesh_label(now).in(translation()));
      continue;
    }
    const MeshCounts before = entry.simplified ? counts_before(o) : counts;
    const std::string label = mesh_label(now, before, metric, written.error).in(translation());
    write_group(changing(), o, {written.mesh, *written.form.blocks, label, before, original});
  }
  std::vector<MeshEntry> written;
  for (const ChangedMesh& m : meshes) written.push_back(m.entry);
  list_meshes(written);
}

bool SvgDocument::take_label(const MeshObject& object) {
  changing();
  return take_written_label(
      object, [&](const std::string& label) { return is_mesh_label(label, translation()); });
}

std::string SvgDocument::new_memory(const ChangedMesh& m) const {
  if (!m.original) return "";
  const bool stays_one = !m.written.form.blocks;
  const bool stays_what_it_is = stays_one != m.entry.simplified;
  if (stays_what_it_is && !originals() && remembered_original(m.entry))
    return *memory_of(object(m.entry));
  const std::vector<Overlap> overlaps = all_overlaps(*m.original, m.frame);
  const Affine place = stays_one ? mesh_to_gradient(svg_, object(m.entry)) : Affine();
  if (place == Affine()) return remember(*m.original, overlaps);
  MeshParts parts = subdivided(*m.original, 1);
  transform(parts, place);
  return remember(build_derived_mesh(parts), overlaps);
}

void SvgDocument::replace_gradient(const ChangedMesh& m, const std::string& original,
                                   GradientsByOrigin& by_origin) {
  constexpr std::size_t names = 120;  // Of the attributes and their namespace, and a fingerprint.
  const bool has_remembered = remembered_original(m.entry) != nullptr;
  const bool must_fit = !original.empty() && !has_remembered;
  // Of the bytes that were read as well, to which serializing may add a declaration.
  const std::size_t before = must_fit ? std::min(bytes().size(), text().size()) : 0;
  const double tolerance = coons_tolerance(m.frame);
  const ColorTexts texts = color_texts(svg_, object(m.entry));
  const MeshObject written = write_mesh_gradient(changing(), object(m.entry), m.written.mesh,
                                                 tolerance, texts, &by_origin);
  // What was measured against a picture has no other original, and still looks like that.
  if (!m.original && remembered_picture(svg_, written))
    return remember_original(changing(), written, m.written.mesh, tolerance, "");
  const std::size_t more = original.size() + texts.list().size() + names;
  if (original.empty() || (must_fit && text().size() + more > before)) return;
  remember_original(changing(), written, m.written.mesh, tolerance, original);
  remember_color_texts(written, texts);
}

bool SvgDocument::remembers_when_edited(const MeshEntry& entry) const {
  return !entry.simplified || memory_of(object(entry));
}

void SvgDocument::replace_by(const std::vector<std::pair<MeshEntry, Look>>& looks) {
  remove_hidden_originals(changing());
  for (const auto& [entry, look] : looks) {
    if (const auto* picture = std::get_if<PlacedPng>(&look))
      write_picture(svg_, object(entry), *picture);
    else
      write_linear(svg_, object(entry), std::get<LinearColors>(look));
  }
  remove_meshes(svg_);
  // Nothing that was read is known to be there still.
  objects_.clear();
  list_meshes();
  mark_changed();
}

void SvgDocument::check_one(const Mesh& mesh) const {
  if (!find_grid(mesh)) throw InputError("its patches do not make up one rectangle.");
  if (!has_one_color_at_each_point(mesh))
    throw InputError("it has several colours at one point, which one mesh gradient cannot hold.");
}

std::shared_ptr<const WritingRules> SvgDocument::rules_of_one(const MeshEntry&) const {
  return gradient_rules({});
}

void SvgDocument::write_as_one(const std::vector<std::pair<MeshEntry, Mesh>>& meshes,
                               int resolution) {
  std::vector<double> tolerances;
  for (const auto& [entry, mesh] : meshes)
    tolerances.push_back(coons_tolerance(frame_of(*this, entry, mesh, resolution)));
  // All are looked at before the first is changed.
  for (const auto& [entry, mesh] : meshes) check_restorable(svg_, object(entry));
  std::vector<MeshEntry> written;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const MeshEntry& entry = written.emplace_back(meshes[i].first);
    const std::string original = remembered_original(entry) ? *memory_of(object(entry)) : "";
    const ColorTexts texts = color_texts(svg_, object(entry));
    const MeshObject shape = restore_shape(changing(), object(entry));
    const MeshObject one = write_mesh_gradient(svg_, shape, meshes[i].second, tolerances[i], texts);
    if (original.empty()) continue;
    remember_original(svg_, one, meshes[i].second, tolerances[i], original);
    remember_color_texts(one, texts);
  }
  list_meshes(written);
  mark_changed();
}

Message SvgDocument::updated_label(const MeshEntry& group, const WrittenForm& form) const {
  const MeshCounts now = counts_of(form.surface), before = counts_before(object(group));
  const std::shared_ptr<const Mesh> original = recalled(group);
  if (!original) return mesh_label(now, before);
  const SimplifyOptions usual;
  const Reference reference(*original, frame_of(*this, group, *original, usual.resolution),
                            usual.metric);
  const MeasuredSurface measured(reference, form.surface, form.masks_opacity(), nullptr);
  return mesh_label(now, before, usual.metric, measured.error().mean);
}

std::vector<UpdateReport> SvgDocument::update(const std::vector<std::string>& ids) {
  std::vector<UpdateReport> reports = update_edited(selected(ids));
  if (std::ranges::any_of(reports, &UpdateReport::changed)) mark_changed();
  return reports;
}

std::vector<UpdateReport> SvgDocument::update_edited(const std::vector<MeshEntry>& entries) {
  struct Edited {
    const MeshEntry& entry;
    const Mesh& mesh;
    WrittenForm form;
    std::string label;
    MeshCounts before;
    /// The mesh that the group remembers from now on, as the value of its attribute.
    std::string original;
  };
  // All groups are read before the first is written.
  std::vector<UpdateReport> reports;
  std::vector<Edited> edited;
  for (const MeshEntry& entry : entries) {
    if (!entry.simplified) continue;
    const Mesh& mesh = read(entry).mesh;
    if (!read(entry).edited) {
      reports.push_back({entry.id, counts_of(mesh), objects(entry), false});
      continue;
    }
    const Frame frame = frame_of(*this, entry, mesh, SimplifyOptions().resolution);
    // Painted in the order of before, in which the person has seen them.
    WrittenForm form = naming(entry, [&] { return rules(entry, false)->form(mesh, frame); });
    reports.push_back({entry.id, counts_of(form.surface), form.object_count(), true});
    std::string label = updated_label(entry, form).in(translation());
    std::string original =
        memory_of(object(entry)) ? remember(mesh, find_overlaps(mesh, frame)) : "";
    edited.push_back({entry, mesh, std::move(form), std::move(label), counts_before(object(entry)),
                      std::move(original)});
  }
  if (reports.empty())
    throw InputError(
        "{0}: only meshes that are blocks can be updated; one mesh gradient needs no update.",
        name());

  std::vector<MeshEntry> written;
  for (const Edited& e : edited) {
    take_label(object(e.entry));
    write_group(changing(), object(e.entry),
                {e.mesh, *e.form.blocks, e.label, e.before, e.original, true});
    written.push_back(e.entry);
  }
  list_meshes(written);
  return reports;
}

}  // namespace gradmesh
