#include "app/document/svg_document.h"

#include "app/document/document_picture.h"
#include "app/document/frames.h"
#include "app/document/mesh_label.h"
#include "app/document/svg_rules.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "form/handles.h"
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
#include "formats/svg/tree/visible.h"
#include "formats/svg/values/mesh_outline.h"
#include "formats/text/scanner.h"
#include "mesh/build.h"
#include "mesh/rectangle.h"
#include "mesh/subdivide.h"
#include "ops/split/without_faces.h"
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

SvgDocument::SvgDocument(std::string_view bytes, const std::string& name)
    : Document(DocumentFile(name, bytes)), svg_(SvgTree::parse(bytes, name)) {
  list_meshes();
}

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

bool SvgDocument::recognises(std::string_view bytes) { return trimmed(bytes).starts_with('<'); }

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

void SvgDocument::list_meshes(const std::vector<MeshEntry>& written) {
  const std::vector<MeshObject> objects = std::exchange(objects_, mesh_objects(changing()));
  const std::vector<MeshEntry> entries = std::exchange(entries_, {});
  auto read = std::exchange(read_, {});
  const auto is_written = [&](const MeshObject& o) {
    return std::ranges::find(written, o.id, &MeshEntry::id) != written.end();
  };
  for (const MeshObject& o : objects_) {
    MeshEntry& entry = entries_.emplace_back(
        MeshEntry{int(entries_.size()), o.id, o.role, o.is_group(), o.kept != nullptr});
    read_.emplace_back();
    const auto known = std::size_t(std::ranges::find(objects, o) - objects.begin());
    if (known == objects.size() || is_written(o)) {
      entry.refused = refusal(entry);
    } else {
      entry.refused = entries[known].refused;
      read_.back() = std::move(read[known]);
    }
  }
}

std::optional<Message> SvgDocument::refusal(const MeshEntry& entry) const {
  try {
    frame_of(*this, entry, mesh(entry), 1);
    return std::nullopt;
  } catch (const InputError& error) {
    return error.message();
  }
}

Message SvgDocument::all_refusals(const std::vector<std::size_t>& places) const {
  constexpr std::size_t most = 5;
  Message all = *entries_[places.front()].refused;
  for (std::size_t i = 1; i < std::min(places.size(), most); ++i)
    all = Message("{0} {1}", all, *entries_[places[i]].refused);
  if (places.size() <= most) return all;
  return Message("{0} {1} more meshes cannot be changed either.", all, places.size() - most);
}

std::vector<MeshEntry> SvgDocument::named(const std::vector<std::string>& ids) const {
  std::vector<bool> found(entries_.size());
  const auto choose = [&](const std::vector<std::size_t>& places) {
    for (const std::size_t i : places) found[i] = true;
    if (std::ranges::all_of(places, [&](std::size_t i) { return entries_[i].refused.has_value(); }))
      throw InputError(all_refusals(places));
  };
  for (const std::string& id : ids) choose(objects_named(svg_, objects_, id));
  if (ids.empty()) choose(objects_shown(svg_, objects_));
  std::vector<MeshEntry> chosen;
  for (const MeshEntry& entry : entries_)
    if (found[std::size_t(entry.index)]) chosen.push_back(entry);
  return chosen;
}

std::vector<MeshEntry> SvgDocument::selected(const std::vector<std::string>& ids) const {
  std::vector<MeshEntry> entries = named(ids);
  std::erase_if(entries, [](const MeshEntry& entry) { return entry.refused.has_value(); });
  return entries;
}

std::vector<MeshEntry> SvgDocument::refused(const std::vector<std::string>& ids) const {
  std::vector<MeshEntry> entries = named(ids);
  std::erase_if(entries, [](const MeshEntry& entry) { return !entry.refused; });
  return entries;
}

std::vector<UnusedMesh> SvgDocument::unused() const {
  std::vector<UnusedMesh> meshes;
  for (const auto& [id, patches] : unused_gradients(svg_, objects_))
    meshes.push_back({id, patches});
  return meshes;
}

const SvgDocument::ReadMesh& SvgDocument::read(const MeshEntry& entry) const {
  std::optional<ReadMesh>& known = read_[std::size_t(entry.index)];
  if (known) return *known;
  if (entry.simplified) {
    known = group_mesh(entry);
  } else {
    const MeshParts parts = read_mesh(svg_, object(entry));
    known = {naming(entry, [&] { return build_mesh(parts); }), !is_as_written(svg_, object(entry))};
  }
  return *known;
}

SvgDocument::ReadMesh SvgDocument::group_mesh(const MeshEntry& group) const {
  const EditedBlocks blocks = read_edited_group(svg_, object(group));
  return naming(group, [&] {
    const Reconciled whole = reconcile(blocks);
    std::vector<Face> removed;
    for (const int patch : removed_patches(blocks)) removed.push_back(Face{patch});
    ReadMesh read{build_mesh(whole.parts), whole.edited || !removed.empty()};
    if (!removed.empty()) read.mesh = without_faces(std::move(read.mesh), removed);
    return read;
  });
}

std::shared_ptr<const Mesh> SvgDocument::recalled(const MeshEntry& entry) const {
  read(entry);
  std::optional<std::shared_ptr<const Mesh>>& known = read_[std::size_t(entry.index)]->recalled;
  if (!known) {
    const auto parts = recalled_mesh(svg_, object(entry));
    known = parts ? std::make_shared<const Mesh>(build_mesh(*parts)) : nullptr;
  }
  return *known;
}

std::shared_ptr<const Mesh> SvgDocument::remembered_original(const MeshEntry& entry) const {
  return read(entry).edited ? nullptr : recalled(entry);
}

Affine SvgDocument::view(const MeshEntry& entry) const {
  return to_document(object(entry)) * mesh_to_user(svg_, object(entry));
}

int SvgDocument::objects(const MeshEntry& entry) const {
  return entry.simplified ? block_count(object(entry)) : 1;
}

Message SvgDocument::describe(const MeshEntry& entry) const {
  return Message("{0}: {1}", name(), gradmesh::describe(object(entry)));
}

std::optional<VisibleArea> SvgDocument::visible_area(const MeshEntry& entry) const {
  const MeshObject& o = object(entry);
  std::optional<VisibleArea> area = gradmesh::visible_area(svg_, o);
  if (area && !o.is_group()) {
    const Affine to_mesh = mesh_to_user(svg_, o).inverse();
    for (std::vector<FilledOutline>& set : area->sets)
      for (FilledOutline& filled : set) filled.outline = mapped(std::move(filled.outline), to_mesh);
  }
  return area;
}

std::vector<FilledOutline> SvgDocument::covered(const std::vector<std::string>& ids) const {
  std::vector<FilledOutline> all;
  for (const std::string& id : ids)
    for (FilledOutline& filled : covered_area(svg_, id)) all.push_back(std::move(filled));
  return all;
}

ShapeOnPicture SvgDocument::shape_on_picture(const std::string& id, const std::string& image,
                                             const std::vector<std::string>& guides,
                                             glm::dvec2 pixels) const {
  return gradmesh::shape_on_picture(svg_, id, image, guides, pixels);
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

Affine SvgDocument::picture_to_mesh(const MeshEntry& entry, const std::string& image,
                                    glm::dvec2 pixels) const {
  return mesh_to_user(svg_, object(entry)).inverse() *
         shape_on_picture(entry.id, image, {}, pixels).to_mesh;
}

std::optional<RememberedPicture> SvgDocument::traced_from(const MeshEntry& entry) const {
  if (entry.simplified || read(entry).edited) return {};
  return remembered_picture(svg_, object(entry));
}

bool SvgDocument::lies_as_traced(const MeshEntry& entry, const RememberedPicture& picture,
                                 glm::dvec2 pixels) const {
  // Pixels of the file: what rounding a document's numbers may do.
  constexpr double hardly_moved = 0.05;
  const Affine moved = picture.to_mesh.inverse() * picture_to_mesh(entry, picture.image, pixels);
  for (const glm::dvec2 corner : {glm::dvec2(0.0), glm::dvec2(pixels.x, 0), pixels})
    if (!(glm::distance(moved.point(corner), corner) <= hardly_moved)) return false;
  return true;
}

std::shared_ptr<const Original> SvgDocument::traced_original(const MeshEntry& entry,
                                                             int resolution) const {
  return gradmesh::traced_original(*this, entry, resolution);
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

ChosenPatches SvgDocument::block(const std::string& id) const {
  const auto [place, faces, faces_of_all] = find_block(svg_, objects_, id);
  const MeshEntry& entry = entries_[place];
  if (faces_of_all != mesh(entry).face_count())
    fail(object(entry), Message("one of its blocks is missing: use Update after Editing first"));
  ChosenPatches chosen{entry, {faces.rows, faces.columns, {}}};
  for (int i = 0; i < faces.rows * faces.columns; ++i)
    chosen.rectangle.tops.push_back(mesh(entry).sides(Face{faces.first + i})[0]);
  return chosen;
}

ChosenPatches SvgDocument::rectangle(const std::string& id) const {
  for (const MeshEntry& entry : entries_) {
    if (entry.id != id) continue;
    if (entry.simplified)
      throw InputError(
          "{0}: it is made of blocks; choose one of them, in Inkscape after a double click.",
          describe(entry));
    return whole(entry);
  }
  return block(id);
}

bool SvgDocument::remembers_when_edited(const MeshEntry& entry) const {
  return !entry.simplified || memory_of(object(entry));
}

SvgDocument::Place SvgDocument::place(const MeshEntry& entry) const {
  const MeshObject& o = object(entry);
  Place place;
  place.to_user = mesh_to_user(svg_, o);
  place.to_page = to_page(svg_, o);
  place.seen = visible_area(entry);
  place.reach = stroke_reach(svg_, o);
  place.fills_shape = gradmesh::fills_shape(o);
  return place;
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

SvgDocument& as_svg(Document& document, const Message& otherwise) {
  if (auto* const svg = dynamic_cast<SvgDocument*>(&document)) return *svg;
  throw InputError(otherwise);
}

}  // namespace gradmesh
