#include "formats/svg/group/memory.h"

#include <algorithm>

#include "base/error.h"
#include "base/hash.h"
#include "files/base64.h"
#include "files/zip.h"
#include "formats/hemesh/hemesh.h"
#include "formats/packed/patches.h"
#include "formats/svg/gradient/mesh_gradient.h"
#include "formats/svg/gradient/written_gradient.h"
#include "formats/svg/group/mesh_group.h"
#include "formats/svg/tree/own.h"
#include "formats/svg/values/curves.h"
#include "formats/svg/xml/node.h"
#include "mesh/build.h"
#include "mesh/rectangle.h"

namespace gradmesh {
namespace {

/// libxml2 takes no attribute beyond ten million bytes, and Inkscape reads with libxml2.
constexpr std::size_t longest_attribute = 9'000'000;
/// Most bytes of a document in a memory: far more than a mesh that fits into the longest attribute
/// takes.
constexpr std::size_t most_bytes = 64 << 20;
/// How many times its size a memory may unpack to, beyond the first bytes, which hold a mesh of as
/// many equal patches as the limit allows. zlib could pack a thousand times, so that small
/// documents took as much memory as large ones.
constexpr std::size_t most_times = 100, first_bytes = 1 << 20;

std::optional<std::string> unzipped(std::string_view memory) {
  const auto bytes = base64_bytes(memory);
  if (!bytes) return std::nullopt;
  return unpack_zlib(*bytes, std::min(most_bytes, first_bytes + most_times * bytes->size()));
}

std::string unless_too_long(std::string memory) {
  return memory.size() <= longest_attribute ? std::move(memory) : "";
}

/// What packed bytes begin with, in base85, and what is no digit of base64.
constexpr char packed_mark = '~';
constexpr std::size_t check_size = 4;

std::string check_of(std::string_view bytes) {
  Hash hash;
  hash.add(bytes);
  const auto folded = std::uint32_t(hash.value() ^ hash.value() >> 32);
  std::string check;
  for (unsigned i = 0; i < check_size; ++i) check += char(std::uint8_t(folded >> 8 * i));
  return check;
}

/// For meshes that have no decimal step, as those that were turned. With 18, a further run found
/// 0.01005 where the run before had kept to 0.01; with 22 errors differ by 1e-7.
constexpr int precision = 22;

std::vector<PatchGrid> grids_of(const std::vector<Rectangle>& blocks, const auto& patch) {
  std::vector<PatchGrid> grids;
  for (const Rectangle& block : blocks) {
    PatchGrid& grid = grids.emplace_back(PatchGrid{block.rows, block.columns, {}});
    for (const Halfedge top : block.tops) grid.patches.push_back(patch(top));
  }
  return grids;
}

std::string packed(PackedMesh mesh) {
  const std::string bytes = pack(std::move(mesh), precision);
  return unless_too_long(packed_mark + base85(bytes + check_of(bytes)));
}

/// Returns what a memory holds; nothing if it is something else.
std::optional<PackedMesh> unpacked(std::string_view memory) {
  if (!memory.starts_with(packed_mark)) return std::nullopt;
  const auto bytes = base85_bytes(memory.substr(1));
  if (!bytes || bytes->size() < check_size) return std::nullopt;
  const std::string_view whole = *bytes, mesh = whole.substr(0, whole.size() - check_size);
  return whole.substr(mesh.size()) == check_of(mesh) ? unpack(mesh) : std::nullopt;
}

/// Returns the blocks of a mesh; one without a search if it is a grid in the order of its faces.
std::vector<Rectangle> blocks_of(const Mesh& mesh, const std::vector<Overlap>& overlaps) {
  const auto grid = find_grid(mesh);
  const auto face = [&](Halfedge top) { return mesh.face(top); };
  if (grid && std::ranges::is_sorted(grid->tops, {}, face) && has_one_color_at_each_point(mesh, 0))
    return {*grid};
  return block_form(mesh, 0, overlaps).blocks;
}

/// Returns the group in a memory that gradmesh 0.1 has written.
const xmlNode* group_in(const SvgTree& tree) {
  const auto groups = child_elements(tree.root(), "g");
  if (groups.empty()) throw InputError("{0}: there are no patches in it.", "memory");
  return groups.front();
}

MeshParts parts_in(const PackedMesh& mesh) {
  const auto curves = parse_curves(mesh.curves);
  MeshParts parts = parts_of(mesh.grids, curves.value_or(std::vector<CurveParts>()));
  parts.smooth = mesh.smooth;
  return parts;
}

/// Returns what bytes hold that were unzipped.
MeshParts read(const std::string& bytes) {
  if (bytes.starts_with("HEMESH")) return read_hemesh(bytes, "memory");
  const SvgTree tree = SvgTree::parse(bytes, "memory");
  return read_mesh_group(tree, group_in(tree));
}

/// Calls `read` and returns its result; nothing where that is no mesh.
template <class Read>
auto if_sound(const Read& read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

std::string remember(const Mesh& mesh, const std::vector<Overlap>& overlaps) {
  if (mesh.color_model() == ColorModel::bicubic)
    return unless_too_long(base64(pack_zlib(write_hemesh(mesh))));
  const std::vector<Rectangle> blocks = blocks_of(mesh, overlaps);
  const std::string curves = format_curves(mesh, blocks);
  const auto patch = [&](Halfedge top) { return mesh.patch(top); };
  return packed({mesh.is_smooth(), curves, grids_of(blocks, patch)});
}

std::string remember_blocks(const Mesh& mesh, const BlockForm& form) {
  const auto patch = [&](Halfedge top) { return written_patch(mesh, top, form); };
  return packed({.grids = grids_of(form.blocks, patch)});
}

std::optional<MeshParts> recall(std::string_view memory) {
  return if_sound([&]() -> MeshParts {
    const auto packed = unpacked(memory);
    const auto bytes = packed ? std::nullopt : unzipped(memory);
    if (!packed && !bytes) throw InputError("{0} cannot be unpacked: it is damaged.", "memory");
    MeshParts parts = packed ? parts_in(*packed) : read(*bytes);
    build_mesh(parts);
    return parts;
  });
}

std::optional<std::vector<PatchGrid>> recall_blocks(std::string_view memory) {
  if (auto packed = unpacked(memory)) return std::move(packed->grids);
  const auto bytes = unzipped(memory);
  if (!bytes) return std::nullopt;
  return if_sound([&] {
    const SvgTree tree = SvgTree::parse(*bytes, "memory");
    return read_mesh_blocks(tree, group_in(tree));
  });
}

std::optional<std::string> memory_of(const MeshObject& object) {
  return object.is_group() ? own_attribute(object.node, "original") : original_of(object);
}

std::optional<MeshParts> recalled_mesh(const SvgTree& tree, const MeshObject& object) {
  const auto memory = memory_of(object);
  auto parts = memory ? recall(*memory) : std::nullopt;
  if (parts && !object.is_group()) transform(*parts, mesh_to_gradient(tree, object).inverse());
  return parts;
}

}  // namespace gradmesh
