#include "formats/svg/write/memory.h"

#include <algorithm>
#include <map>

#include "base/error.h"
#include "files/base64.h"
#include "files/zip.h"
#include "form/written_patch.h"
#include "formats/hemesh/read_hemesh.h"
#include "formats/hemesh/write_hemesh.h"
#include "formats/packed/patches.h"
#include "formats/svg/read/curves.h"
#include "formats/svg/read/document.h"
#include "formats/svg/read/read_group.h"
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

std::optional<std::string> unpacked(std::string_view memory) {
  const auto bytes = base64_bytes(memory);
  if (!bytes) return std::nullopt;
  return unzip(*bytes, std::min(most_bytes, first_bytes + most_times * bytes->size()));
}

std::string packed(const std::string& text) {
  std::string memory = base64(zip(text));
  return memory.size() <= longest_attribute ? memory : "";
}

/// With 18, a further run found 0.01005 where the run before had kept to 0.01; with 22 errors
/// differ by 1e-7.
constexpr int precision = 22;

std::vector<PatchGrid> grids_of(const std::vector<Rectangle>& blocks, const auto& patch) {
  std::vector<PatchGrid> grids;
  for (const Rectangle& block : blocks) {
    PatchGrid& grid = grids.emplace_back(PatchGrid{block.rows, block.columns, {}});
    for (const Halfedge top : block.tops) grid.patches.push_back(patch(top));
  }
  return grids;
}

/// What the bytes of a memory hold, if they are packed patches.
struct Packed {
  bool smooth = false;
  std::string_view curves = {};
  std::vector<PatchGrid> grids = {};
};

constexpr char rough_letter = 'p', smooth_letter = 's';

std::string pack(const Packed& parts) {
  std::string bytes(1, parts.smooth ? smooth_letter : rough_letter);
  bytes += parts.curves;
  bytes += '\n';
  return packed(bytes + pack_patches(parts.grids, precision));
}

/// Returns what the bytes hold; nothing if they are something else.
std::optional<Packed> unpack(std::string_view bytes) {
  const std::size_t end = bytes.find('\n');
  const bool smooth = bytes.starts_with(smooth_letter);
  if (end == bytes.npos || (!smooth && !bytes.starts_with(rough_letter))) return std::nullopt;
  auto grids = unpack_patches(bytes.substr(end + 1));
  if (!grids) return std::nullopt;
  return Packed{smooth, bytes.substr(1, end - 1), std::move(*grids)};
}

bool has_one_color_at_each_point(const Mesh& mesh) {
  std::map<Point, glm::dvec4> colors;
  for (const Halfedge h : mesh.halfedges())
    if (mesh.is_leaf(h) &&
        colors.emplace(mesh.origin(h), mesh[h].color).first->second != mesh[h].color)
      return false;
  return true;
}

/// Returns the blocks of a mesh; one without a search if it is a grid in the order of its faces.
std::vector<Rectangle> blocks_of(const Mesh& mesh, const std::vector<Overlap>& overlaps) {
  const auto grid = find_grid(mesh);
  const auto face = [&](Halfedge top) { return mesh.face(top); };
  if (grid && std::ranges::is_sorted(grid->tops, {}, face) && has_one_color_at_each_point(mesh))
    return {*grid};
  return block_form(mesh, 0, overlaps).blocks;
}

/// Returns the group in a memory that an older version has written.
const xmlNode* group_in(const SvgDocument& document) {
  const auto groups = child_elements(document.root(), "g");
  if (groups.empty()) throw InputError("{0}: there are no patches in it.", "memory");
  return groups.front();
}

MeshParts read(const std::string& bytes) {
  if (bytes.starts_with("HEMESH")) return read_hemesh(bytes, "memory");
  if (const auto packed = unpack(bytes)) {
    const auto curves = parse_curves(packed->curves);
    MeshParts parts = parts_of(packed->grids, curves.value_or(std::vector<CurveParts>()));
    parts.smooth = packed->smooth;
    return parts;
  }
  const SvgDocument document = SvgDocument::parse(bytes, "memory");
  return read_mesh_group(document, group_in(document));
}

}  // namespace

std::string remember(const Mesh& mesh, const std::vector<Overlap>& overlaps) {
  if (mesh.color_model() == ColorModel::bicubic) return packed(write_hemesh(mesh));
  const std::vector<Rectangle> blocks = blocks_of(mesh, overlaps);
  const std::string curves = format_curves(mesh, blocks);
  const auto patch = [&](Halfedge top) { return patch_from(mesh, top); };
  return pack({mesh.is_smooth(), curves, grids_of(blocks, patch)});
}

std::string remember_blocks(const Mesh& mesh, const BlockForm& form) {
  const auto patch = [&](Halfedge top) {
    return as_written(patch_from(mesh, top), form.coons_tolerance, form.masks_opacity);
  };
  return pack({.grids = grids_of(form.blocks, patch)});
}

std::optional<MeshParts> recall(std::string_view memory) {
  const auto bytes = unpacked(memory);
  if (!bytes) return std::nullopt;
  try {
    MeshParts parts = read(*bytes);
    build_mesh(parts);
    return parts;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::optional<std::vector<PatchGrid>> recall_blocks(std::string_view memory) {
  const auto bytes = unpacked(memory);
  if (!bytes) return std::nullopt;
  if (auto packed = unpack(*bytes)) return std::move(packed->grids);
  try {
    const SvgDocument document = SvgDocument::parse(*bytes, "memory");
    return read_mesh_blocks(document, group_in(document));
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace gradmesh
