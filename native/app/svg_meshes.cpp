#include "app/svg_meshes.h"

#include "app/mesh_label.h"
#include "app/svg_rules.h"

#include <algorithm>

#include "form/blocks.h"
#include "formats/svg/read/read_group.h"
#include "formats/svg/read/read_mesh.h"
#include "formats/svg/read/restore_shape.h"
#include "formats/svg/read/visible.h"
#include "formats/svg/read/written_gradient.h"
#include "formats/svg/values/length.h"
#include "formats/svg/values/mesh_names.h"
#include "formats/svg/values/shape.h"
#include "formats/svg/write/keep_original.h"
#include "formats/svg/write/memory.h"
#include "formats/svg/write/mesh_outline.h"
#include "formats/svg/write/remove_meshes.h"
#include "formats/svg/write/write_group.h"
#include "formats/svg/write/write_linear.h"
#include "formats/svg/write/write_mesh.h"
#include "formats/svg/write/write_new.h"
#include "formats/svg/xml/node.h"
#include "formats/text/excerpt.h"
#include "formats/text/scanner.h"
#include "mesh/build.h"
#include "mesh/rectangle.h"
#include "mesh/subdivide.h"
#include "ops/split/without_faces.h"
#include "raster/overlaps.h"
#include "simplify/options.h"
#include "trial/edit_error.h"

namespace gradmesh {
namespace {

bool is_inside(const xmlNode* node, const xmlNode* ancestor) {
  while (node && node != ancestor) node = parent_element(node);
  return node != nullptr;
}

/// Returns true if the object is, or is inside of, the element that was named. A hidden original
/// counts only if it or something in it was named.
bool is_named_by(const xmlNode* named, const MeshObject& object) {
  return is_inside(object.node, named) && (!object.kept || is_inside(named, object.kept));
}

/// Returns why an element is no mesh and holds none.
Message why_unpainted(const xmlNode* node) {
  for (const xmlNode* outer = node; outer; outer = parent_element(outer))
    if (svg_name(outer) == "clipPath")
      return Message("it is in a clipPath, of which nothing is painted");
  return Message("it is not painted by a mesh gradient");
}

/// Returns all overlaps, also those at hidden pixels, since what is hidden now may be seen later.
std::vector<Overlap> all_overlaps(const Mesh& mesh, Frame frame) {
  frame.hidden = nullptr;
  return find_overlaps(mesh, frame);
}

}  // namespace

SvgMeshes::SvgMeshes(std::string_view bytes, const std::string& name)
    : Document(name, bytes), svg_(SvgDocument::parse(bytes, name)) {
  list_meshes();
}

bool SvgMeshes::recognises(std::string_view bytes) { return trimmed(bytes).starts_with('<'); }

std::string SvgMeshes::write_new(const NewDocument& document) {
  const auto& [mesh, original, frame, page, translation] = document;
  const WrittenForm form = exact_block_rules()->form(mesh, frame);
  const MeshCounts counts = counts_of(form.surface);
  const std::string label = mesh_label(counts).in(translation);
  return new_svg({page.x, page.y}, outline_path(original), {mesh, *form.blocks, label, counts})
      .serialize();
}

void SvgMeshes::check_conversion(const Format& to) const {
  if (to == format()) throw InputError("{0} is an SVG document already.", name());
}

Message SvgMeshes::why_not(ColorModel) const {
  return Message(
      "{0}: an SVG document cannot hold bicubic colours; gradmesh convert makes a .hemesh file "
      "of it, which can.",
      name());
}

void SvgMeshes::list_meshes() {
  objects_ = mesh_objects(svg_);
  entries_.clear();
  for (const MeshObject& o : objects_)
    entries_.push_back(
        {int(entries_.size()), o.id, o.role, o.gradient == nullptr, o.kept != nullptr});
  read_.assign(entries_.size(), std::nullopt);
  for (MeshEntry& entry : entries_) entry.refused = refusal(entry);
}

std::optional<Message> SvgMeshes::refusal(const MeshEntry& entry) const {
  try {
    frame(entry, mesh(entry), 1);
    return std::nullopt;
  } catch (const InputError& error) {
    return error.message();
  }
}

std::vector<MeshEntry> SvgMeshes::named(const std::vector<std::string>& ids) const {
  std::vector<bool> found(entries_.size());
  const auto find_below = [&](const xmlNode* place, const InputError& otherwise) {
    const MeshEntry* unread = nullptr;
    bool reads = false;
    for (const MeshEntry& entry : entries_) {
      if (!is_named_by(place, object(entry))) continue;
      found[std::size_t(entry.index)] = true;
      reads = reads || !entry.refused;
      if (!unread && entry.refused) unread = &entry;
    }
    if (!reads) throw unread ? InputError(*unread->refused) : otherwise;
  };
  for (const std::string& id : ids) {
    const xmlNode* place = svg_.find(id);
    if (!place) throw InputError("{0}: there is no object with the id {1}.", name(), excerpt(id));
    find_below(place, InputError("{0}: {1}: {2}.", name(), gradmesh::describe(place),
                                 why_unpainted(place)));
  }
  if (ids.empty())
    find_below(
        svg_.root(),
        InputError("{0}: no object in this document is painted by a mesh gradient.", name()));
  std::vector<MeshEntry> chosen;
  for (const MeshEntry& entry : entries_)
    if (found[std::size_t(entry.index)]) chosen.push_back(entry);
  return chosen;
}

std::vector<MeshEntry> SvgMeshes::selected(const std::vector<std::string>& ids) const {
  std::vector<MeshEntry> entries = named(ids);
  std::erase_if(entries, [](const MeshEntry& entry) { return entry.refused.has_value(); });
  return entries;
}

std::vector<MeshEntry> SvgMeshes::refused(const std::vector<std::string>& ids) const {
  std::vector<MeshEntry> entries = named(ids);
  std::erase_if(entries, [](const MeshEntry& entry) { return !entry.refused; });
  return entries;
}

std::vector<UnusedMesh> SvgMeshes::unused() const {
  std::vector<UnusedMesh> meshes;
  for (const xmlNode* gradient : unused_mesh_gradients(svg_, objects_)) {
    UnusedMesh mesh{attribute(gradient, "id").value_or("")};
    for (const xmlNode* row : mesh_rows(gradient)) mesh.patches += int(mesh_patches(row).size());
    meshes.push_back(std::move(mesh));
  }
  return meshes;
}

const SvgMeshes::ReadMesh& SvgMeshes::read(const MeshEntry& entry) const {
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

SvgMeshes::ReadMesh SvgMeshes::group_mesh(const MeshEntry& group) const {
  const xmlNode* node = object(group).node;
  const auto memory = attribute(node, "written", gradmesh_namespace);
  const auto written = memory ? recall_blocks(*memory) : std::nullopt;
  const EditedBlocks blocks =
      read_edited_group(svg_, node, written.value_or(std::vector<PatchGrid>()));
  return naming(group, [&] {
    const Reconciled whole = reconcile(blocks);
    std::vector<Face> removed;
    for (const int patch : removed_patches(blocks)) removed.push_back(Face{patch});
    ReadMesh read{build_mesh(whole.parts), whole.edited || !removed.empty()};
    if (!removed.empty()) read.mesh = without_faces(std::move(read.mesh), removed);
    return read;
  });
}

std::optional<std::string> SvgMeshes::memory(const MeshEntry& entry) const {
  const MeshObject& o = object(entry);
  const std::string name = o.gradient ? original_name(o.role) : "original";
  return attribute(o.node, name.c_str(), gradmesh_namespace);
}

std::shared_ptr<const Mesh> SvgMeshes::recalled(const MeshEntry& entry) const {
  read(entry);
  std::optional<std::shared_ptr<const Mesh>>& known = read_[std::size_t(entry.index)]->recalled;
  if (!known) {
    const auto text = memory(entry);
    auto parts = text ? recall(*text) : std::nullopt;
    const MeshObject& o = object(entry);
    if (parts && o.gradient) transform(*parts, mesh_to_gradient(svg_, o).inverse());
    known = parts ? std::make_shared<const Mesh>(build_mesh(*parts)) : nullptr;
  }
  return *known;
}

std::shared_ptr<const Mesh> SvgMeshes::remembered_original(const MeshEntry& entry) const {
  return read(entry).edited ? nullptr : recalled(entry);
}

Affine SvgMeshes::view(const MeshEntry& entry) const {
  const MeshObject& o = object(entry);
  const Affine to_user = o.gradient ? mesh_to_user(svg_, o) : Affine();
  return to_document(o) * to_user;
}

int SvgMeshes::objects(const MeshEntry& entry) const {
  return entry.simplified ? block_count(object(entry).node) : 1;
}

Message SvgMeshes::describe(const MeshEntry& entry) const {
  return Message("{0}: {1}", name(), gradmesh::describe(object(entry).node));
}

std::optional<VisibleArea> SvgMeshes::visible_area(const MeshEntry& entry) const {
  const MeshObject& o = object(entry);
  std::optional<VisibleArea> area = gradmesh::visible_area(svg_, o);
  if (area && o.gradient) {
    const Affine to_mesh = mesh_to_user(svg_, o).inverse();
    for (std::vector<FilledOutline>& set : area->sets)
      for (FilledOutline& filled : set)
        for (std::vector<glm::dvec2>& polygon : filled.outline)
          for (glm::dvec2& p : polygon) p = to_mesh.point(p);
  }
  return area;
}

std::shared_ptr<const WritingRules> SvgMeshes::rules(const MeshEntry& entry, bool stays_one) const {
  if (!stays_one || !is_one_gradient(entry)) return block_rules();
  return gradient_rules(mesh_to_gradient(svg_, object(entry)));
}

void SvgMeshes::replace(const std::vector<ChangedMesh>& meshes, MetricKind metric,
                        const WriteOptions& writing) {
  if (writing.keep_original)
    for (const ChangedMesh& m : meshes) keep_hidden_copy(svg_, object(m.entry));
  for (const ChangedMesh& m : meshes) {
    const auto& [entry, written, counts, frame, measured] = m;
    const std::string original = writing.remember_original ? new_memory(m) : "";
    if (!written.form.blocks) {
      replace_gradient(m, original);
      continue;
    }
    const MeshObject& o = object(entry);
    const MeshCounts now{written.counts().handles, written.mesh.face_count()};
    const MeshCounts before = entry.simplified ? counts_before(o.node) : counts;
    const std::string label = mesh_label(now, before, metric, written.error).in(translation());
    write_mesh(svg_, o, {written.mesh, *written.form.blocks, label, before, original});
  }
  list_meshes();
}

std::string SvgMeshes::new_memory(const ChangedMesh& m) const {
  const bool stays_one = !m.written.form.blocks;
  const bool stays_what_it_is = stays_one != m.entry.simplified;
  if (stays_what_it_is && !has_given_originals() && remembered_original(m.entry))
    return *memory(m.entry);
  const std::vector<Overlap> overlaps = all_overlaps(*m.original, m.frame);
  const Affine place = stays_one ? mesh_to_gradient(svg_, object(m.entry)) : Affine();
  if (place == Affine()) return remember(*m.original, overlaps);
  MeshParts parts = subdivided(*m.original, 1);
  transform(parts, place);
  return remember(build_derived_mesh(parts), overlaps);
}

void SvgMeshes::replace_gradient(const ChangedMesh& m, const std::string& original) {
  constexpr std::size_t names = 120;  // Of the attributes and their namespace, and a fingerprint.
  const bool has_remembered = remembered_original(m.entry) != nullptr;
  const double tolerance = m.written.form.coons_tolerance;
  // Of the bytes that were read as well, to which serializing may add a declaration.
  const std::size_t before = std::min(bytes().size(), svg_.serialize().size());
  const MeshObject written = write_mesh_gradient(svg_, object(m.entry), m.written.mesh, tolerance);
  if (original.empty()) return;
  if (has_remembered || svg_.serialize().size() + original.size() + names <= before)
    remember_original(svg_, written, tolerance, original);
}

ChosenPatches SvgMeshes::block(const std::string& id) const {
  const xmlNode* node = svg_.find(id);
  if (!node) throw InputError("{0}: there is no object with the id {1}.", name(), excerpt(id));
  const xmlNode* group = parent_element(node);
  const auto blocks = group && is_mesh_group(group) ? block_faces(svg_, group)
                                                    : std::map<const xmlNode*, BlockFaces>();
  const auto found = blocks.find(node);
  if (found == blocks.end()) fail(node, Message("it is no block of a simplified mesh"));
  const auto [first, rows, columns] = found->second;
  ChosenPatches chosen{{}, {rows, columns, {}}};
  for (const MeshEntry& entry : entries_)
    if (object(entry).node == group) chosen.entry = entry;
  int faces = 0;
  for (const auto& [path, block] : blocks) faces += block.rows * block.columns;
  if (faces != mesh(chosen.entry).face_count())
    fail(group, Message("one of its blocks is missing: use Update after Editing first"));
  for (int i = 0; i < rows * columns; ++i)
    chosen.rectangle.tops.push_back(mesh(chosen.entry).sides(Face{first + i})[0]);
  return chosen;
}

ChosenPatches SvgMeshes::rectangle(const std::string& id) const {
  for (const MeshEntry& entry : entries_) {
    if (entry.id != id) continue;
    if (entry.simplified)
      throw InputError("{0}: it is made of blocks; choose one of them.", describe(entry));
    const Mesh& whole = mesh(entry);
    if (whole.is_smooth())
      throw InputError(
          "{0}: its colours follow those of the neighbours (type=\"bicubic\"), so that its patches "
          "are not edited one by one.",
          describe(entry));
    const auto grid = find_grid(whole);
    if (!grid) throw InputError("{0}: its mesh is not one rectangle of patches.", describe(entry));
    return {entry, *grid};
  }
  return block(id);
}

SvgMeshes::Rewritten SvgMeshes::rewrite(const MeshEntry& entry, const Mesh& edited,
                                        MetricKind metric, int resolution) {
  std::shared_ptr<const Mesh> original = remembered_original(entry);
  if (!original) original = std::make_shared<const Mesh>(mesh(entry));
  const auto measured = naming(entry, [&] {
    Problem problem(original, nullptr, layout(entry, true), resolution, metric);
    // A rectangle that was one mesh gradient stays one.
    problem.rules = rules(entry, find_grid(edited).has_value());
    return std::pair(problem.measure(edited), problem.frame());
  });
  const auto& [written, frame] = measured;
  WriteOptions writing;
  writing.remember_original = !entry.simplified || memory(entry);
  write({{entry, written, counts_of(*original), frame, original}}, metric, writing);
  return {written.counts(), written.form.object_count(), written.error};
}

SvgMeshes::Place SvgMeshes::place(const MeshEntry& entry) const {
  const MeshObject& o = object(entry);
  Place place;
  if (o.gradient) place.to_user = mesh_to_user(svg_, o);
  place.to_page = to_pixels(svg_.root()) * to_document(o);
  place.seen = visible_area(entry);
  place.fills_shape = o.gradient && o.role == PaintRole::fill && shape_outline(o.node).has_value();
  return place;
}

void SvgMeshes::replace_by(const std::vector<std::pair<MeshEntry, Look>>& looks) {
  remove_hidden_originals(svg_);
  for (const auto& [entry, look] : looks) {
    if (const auto* picture = std::get_if<PlacedPicture>(&look))
      write_picture(svg_, object(entry), *picture);
    else
      write_linear(svg_, object(entry), std::get<LinearColors>(look));
  }
  remove_meshes(svg_);
  list_meshes();
  mark_changed();
}

void SvgMeshes::write_as_one(const std::vector<std::pair<MeshEntry, Mesh>>& meshes,
                             int resolution) {
  std::vector<double> tolerances;
  for (const auto& [entry, mesh] : meshes)
    tolerances.push_back(coons_tolerance(frame(entry, mesh, resolution)));
  // All are looked at before the first is changed.
  for (const auto& [entry, mesh] : meshes) check_restorable(svg_, object(entry));
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const MeshEntry& entry = meshes[i].first;
    const std::string original = remembered_original(entry) ? *memory(entry) : "";
    const MeshObject shape = restore_shape(svg_, object(entry));
    const MeshObject written = write_mesh_gradient(svg_, shape, meshes[i].second, tolerances[i]);
    if (!original.empty()) remember_original(svg_, written, tolerances[i], original);
  }
  list_meshes();
  mark_changed();
}

Message SvgMeshes::updated_label(const MeshEntry& group, const WrittenForm& form) const {
  const xmlNode* node = object(group).node;
  const MeshCounts now = counts_of(form.surface), before = counts_before(node);
  const std::shared_ptr<const Mesh> original = recalled(group);
  if (!original) return mesh_label(now, before);
  const SimplifyOptions usual;
  const Reference reference(*original, frame(group, *original, usual.resolution), usual.metric);
  const FrameError error =
      whole_frame_error(reference, form.surface, form.masks_opacity(), nullptr);
  return mesh_label(now, before, usual.metric, error.mean);
}

std::vector<UpdateReport> SvgMeshes::update_edited(const std::vector<MeshEntry>& entries) {
  struct Edited {
    const MeshObject& group;
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
    const Frame frame = this->frame(entry, mesh, SimplifyOptions().resolution);
    // Painted in the order of before, in which the person has seen them.
    WrittenForm form = naming(entry, [&] { return rules(entry, false)->form(mesh, frame); });
    reports.push_back({entry.id, counts_of(form.surface), form.object_count(), true});
    std::string label = updated_label(entry, form).in(translation());
    std::string original = memory(entry) ? remember(mesh, find_overlaps(mesh, frame)) : "";
    edited.push_back({object(entry), mesh, std::move(form), std::move(label),
                      counts_before(object(entry).node), std::move(original)});
  }
  if (reports.empty())
    throw InputError("{0}: only meshes that were simplified before can be updated.", name());

  for (const Edited& e : edited)
    write_mesh(svg_, e.group, {e.mesh, *e.form.blocks, e.label, e.before, e.original, true});
  list_meshes();
  return reports;
}

}  // namespace gradmesh
