#include "document/document.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "base/error.h"
#include "io/atomic_file.h"
#include "io/blocks.h"
#include "io/svg_group.h"
#include "io/svg_mesh.h"
#include "io/svg_write.h"
#include "io/xml_node.h"
#include "mesh/build.h"

namespace gradmesh {
namespace {

/// Runs `work`; what the core says of a mesh, without knowing whose it is, gets the names of the
/// file and the element.
template <class Work>
auto naming(const MeshObject& object, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    std::string reason = error.what();
    if (reason.ends_with('.')) reason.pop_back();
    fail(object.node, reason);
  }
}

bool is_inside(const xmlNode* node, const xmlNode* ancestor) {
  while (node && node != ancestor) node = parent_element(node);
  return node != nullptr;
}

/// The blocks in which a mesh can be written, in either order.
std::array<std::vector<Block>, 2> possible_blocks(const Mesh& mesh) {
  const std::vector<Block> by_area = find_blocks(mesh);
  return {by_area, in_order_of_faces(by_area)};
}

/// The mesh as a reader will find it in these blocks.
std::vector<Mesh> ways_to_write(const Mesh& mesh, const Frame& frame) {
  std::vector<Mesh> ways;
  for (const std::vector<Block>& blocks : possible_blocks(mesh))
    ways.push_back(build_mesh(block_parts(mesh, blocks, frame.coons_tolerance)));
  return ways;
}

}  // namespace

Document::Document(SvgDocument svg, std::string name, std::string original)
    : svg_(std::move(svg)),
      name_(std::move(name)),
      original_(std::move(original)),
      objects_(mesh_objects(svg_)) {}

Document Document::read_file(const std::filesystem::path& path) {
  return parse(read_bytes(path), path.string());
}

Document Document::parse(std::string_view bytes, const std::string& name) {
  return Document(SvgDocument::parse(bytes, name), name, std::string(bytes));
}

std::vector<MeshObject> Document::selected(const std::vector<std::string>& ids) const {
  if (objects_.empty())
    throw InputError(name_ + ": no object in this document is painted by a mesh gradient.");
  if (ids.empty()) return objects_;
  std::vector<const xmlNode*> places;
  for (const std::string& id : ids) {
    const xmlNode* place = svg_.find(id);
    if (!place) throw InputError(name_ + ": there is no object with the id " + excerpt(id) + ".");
    if (std::ranges::none_of(objects_,
                             [&](const MeshObject& o) { return is_inside(o.node, place); }))
      fail(place, "it is not painted by a mesh gradient");
    places.push_back(place);
  }
  std::vector<MeshObject> found;
  for (const MeshObject& object : objects_)
    if (std::ranges::any_of(places, [&](const xmlNode* p) { return is_inside(object.node, p); }))
      found.push_back(object);
  return found;
}

Mesh Document::mesh(const MeshObject& object) const {
  const MeshParts parts =
      is_mesh_group(object.node) ? read_mesh_group(svg_, object.node) : read_mesh(svg_, object);
  return naming(object, [&] { return build_mesh(parts); });
}

Image Document::render(const MeshObject& object, int resolution,
                       const Rasterizer& rasterizer) const {
  const Mesh painted = mesh(object);
  const Affine view = to_document(object);
  return naming(object,
                [&] { return rasterizer.paint(painted, fit_frame(painted, view, resolution)); });
}

std::vector<MeshReport> Document::simplify(const std::vector<std::string>& ids,
                                           SimplifyOptions options) {
  const std::vector<MeshObject> chosen = selected(ids);
  std::vector<Mesh> meshes;
  for (const MeshObject& object : chosen) meshes.push_back(mesh(object));

  options.ways_to_write = ways_to_write;
  std::vector<MeshReport> reports;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    options.view = to_document(chosen[i]);
    reports.push_back(
        {chosen[i].id, naming(chosen[i], [&] { return gradmesh::simplify(meshes[i], options); })});
  }
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const SimplifyResult& result = reports[i].result;
    if (result.patches_after == result.patches_before) continue;
    const int before =
        is_mesh_group(chosen[i].node) ? patches_before(chosen[i].node) : result.patches_before;
    const std::string label =
        mesh_label(result.patches_after, before, options.metric, result.error);
    const std::vector<Block> blocks = possible_blocks(meshes[i])[result.way];
    write_mesh(svg_, chosen[i], {meshes[i], blocks, result.frame.coons_tolerance, label, before});
    changed_ = true;
  }
  objects_ = mesh_objects(svg_);
  return reports;
}

std::string Document::bytes() const { return changed_ ? svg_.serialize() : original_; }

void Document::write_file(const std::filesystem::path& path) const { write_bytes(path, bytes()); }

std::string mesh_label(int patches, int patches_before, MetricKind metric, double error) {
  char text[96];
  std::snprintf(text, sizeof text, "Gradient mesh: %d of %d patches, %s %.4f", patches,
                patches_before, metric == MetricKind::flip ? "FLIP" : "SSIM", error);
  return text;
}

}  // namespace gradmesh
