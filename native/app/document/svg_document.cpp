#include "app/document/svg_document.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "app/document/document_picture.h"
#include "app/document/frames.h"
#include "formats/svg/gradient/mesh_gradient.h"
#include "formats/svg/gradient/written_gradient.h"
#include "formats/svg/group/memory.h"
#include "formats/svg/group/mesh_group.h"
#include "formats/svg/group/written_label.h"
#include "formats/svg/tree/visible.h"
#include "formats/text/scanner.h"
#include "mesh/build.h"
#include "ops/split/without_faces.h"
#include "simplify/options.h"
#include "trial/measured_surface.h"

namespace gradmesh {

SvgDocument::SvgDocument(std::string_view bytes, const std::string& name)
    : Document(DocumentFile(name, bytes)), svg_(SvgTree::parse(bytes, name)) {
  list_meshes();
}

bool SvgDocument::recognises(std::string_view bytes) { return trimmed(bytes).starts_with('<'); }

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

SvgDocument& as_svg(Document& document, const Message& otherwise) {
  if (auto* const svg = dynamic_cast<SvgDocument*>(&document)) return *svg;
  throw InputError(otherwise);
}

}  // namespace gradmesh
