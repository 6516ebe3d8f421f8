#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "formats/svg/gradient/mesh_gradient.h"
#include "formats/svg/gradient/rows.h"
#include "formats/svg/group/memory.h"
#include "formats/svg/group/mesh_group.h"
#include "formats/svg/group/shape.h"
#include "formats/svg/group/write_group.h"
#include "mesh/build.h"
#include "mesh/rectangle.h"
#include "ops/merge/merge.h"
#include "target.h"

namespace gradmesh::fuzz {
namespace {

constexpr double tolerance = 0.01;

Mesh read(const SvgTree& document, const MeshObject& object) {
  return build_mesh(object.gradient ? read_mesh(document, object)
                                    : read_mesh_group(document, object.node));
}

/// The first mesh that can be read, that no other object shares its id with, so that it is found
/// again, and that is not smooth: such are never written in blocks.
std::optional<std::pair<MeshObject, Mesh>> first_mesh(SvgTree& document) {
  std::optional<std::pair<MeshObject, Mesh>> found;
  const std::vector<MeshObject> objects = mesh_objects(document);
  for (const MeshObject& object : objects) {
    const auto is_alike = [&](const MeshObject& other) {
      return other.id == object.id && other.role == object.role;
    };
    if (std::ranges::count_if(objects, is_alike) > 1) continue;
    accepts([&] { found.emplace(object, read(document, object)); });
    if (found && !found->second.is_smooth()) return found;
  }
  return std::nullopt;
}

/// The object, named by its id and what the mesh paints, in the document as a program finds it that
/// opens what is written.
std::pair<SvgTree, MeshObject> reopened(const SvgTree& document, const std::string& id,
                                        PaintRole role) {
  SvgTree again = SvgTree::parse(document.serialize(), input_name);
  const auto objects = mesh_objects(again);
  const auto found = std::ranges::find_if(
      objects, [&](const MeshObject& object) { return object.id == id && object.role == role; });
  require(found != objects.end(), "the object is there again");
  return {std::move(again), *found};
}

void merge_some(Mesh& mesh) {
  Journal journal(mesh);
  for (int left = 2; left > 0; --left)
    for (const Halfedge h : mesh.halfedges())
      if (can_merge(mesh, h) == MergeObstacle::none) {
        merge(journal, h);
        break;
      }
}

/// Simplifies the mesh and writes it as blocks; false where it is too large by then.
bool write_blocks(SvgTree& document, const MeshObject& object, Mesh mesh) {
  const std::string original = remember(mesh);
  const MeshCounts before = counts_of(mesh);
  merge_some(mesh);
  const BlockForm form = block_form(mesh, tolerance);
  const MeshParts parts = block_parts(mesh, form);
  const Mesh expected = build_mesh(parts);
  require_sound(expected);
  // Documents refuse the others before they write.
  if (!std::ranges::all_of(parts.patches, is_within_limits)) return false;
  write_group(document, object, {mesh, form, "label", before, original});

  const auto [again, group] = reopened(document, object.id, object.role);
  require(group.is_group(), "it is a group");
  const MeshCounts told = counts_before(group);
  require(told.patches == before.patches && told.handles == before.handles,
          "it says how many there were");
  const Mesh written = read(again, group);
  require_sound(written);
  require(written.face_count() == expected.face_count(), "no patch is lost");
  return true;
}

/// Makes one mesh gradient of the group's mesh again, where it is a rectangle.
void write_one(SvgTree& document, const std::string& id, PaintRole role) {
  auto [again, group] = reopened(document, id, role);
  const Mesh mesh = read(again, group);
  if (!find_grid(mesh) ||
      !accepts([&, &again = again, &group = group] { check_restorable(again, group); }))
    return;
  const MeshObject shape = restore_shape(again, group);
  write_mesh_gradient(again, shape, mesh, tolerance);
  const auto [last, object] = reopened(again, shape.id, role);
  require(read(last, object).face_count() == mesh.face_count(), "no patch is lost");
}

}  // namespace

void check(std::string_view bytes) {
  std::optional<SvgTree> document;
  std::optional<std::pair<MeshObject, Mesh>> first;
  if (!accepts([&] {
        document = SvgTree::parse(bytes, input_name);
        first = first_mesh(*document);
      }) ||
      !first)
    return;
  must_accept(
      [&] {
        const auto& [object, mesh] = *first;
        if (write_blocks(*document, object, mesh)) write_one(*document, object.id, object.role);
      },
      "what was written can be read");
}

}  // namespace gradmesh::fuzz
