#include "formats/svg/read/read_group.h"

#include <algorithm>
#include <charconv>
#include <map>

#include "form/written_patch.h"
#include "formats/svg/read/curves.h"
#include "formats/svg/read/read_mesh.h"
#include "formats/svg/values/transform.h"
#include "formats/svg/xml/node.h"
#include "formats/text/excerpt.h"

namespace gradmesh {
namespace {

std::optional<std::string> own_attribute(const xmlNode* node, const char* name) {
  return attribute(node, name, gradmesh_namespace);
}

std::optional<int> own_number(const xmlNode* node, const char* name) {
  const auto text = own_attribute(node, name);
  int value = 0;
  if (!text) return std::nullopt;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
  if (error != std::errc{} || end != text->data() + text->size() || value < 0) return std::nullopt;
  return value;
}

xmlNode* block_gradient(const SvgDocument& document, const xmlNode* group, const xmlNode* path) {
  const auto fill = document.styles().declared(path, "fill");
  xmlNode* gradient = fill ? referenced_mesh(document, *fill) : nullptr;
  if (!gradient) fail(group, Message("{0} has lost its mesh gradient", describe(path)));
  return gradient;
}

/// Returns a block's grid, in the group's user space.
PatchGrid read_block(const SvgDocument& document, const xmlNode* group, xmlNode* path) {
  xmlNode* gradient = block_gradient(document, group, path);
  PatchGrid block = read_mesh_patches(document, {path, {}, PaintRole::fill, gradient});
  if (const auto text = attribute(path, "transform")) {
    const auto affine = parse_transform(*text);
    if (!affine) fail(path, Message("its transform {0} is malformed", excerpt(*text)));
    for (Patch& patch : block.patches) {
      transform(patch, *affine);
      if (!is_within_limits(patch)) fail(path, Message("it reaches beyond 5e8 user units"));
    }
  }
  return block;
}

/// Returns all blocks below `parent`, the group or its mask, in the order of their faces.
std::vector<PatchGrid> read_blocks(const SvgDocument& document, const xmlNode* group,
                                   const xmlNode* parent) {
  std::map<int, PatchGrid> found;
  for (xmlNode* path : child_elements(parent)) {
    const auto face = own_number(path, "face");
    if (!face) continue;
    if (!found.emplace(*face, read_block(document, group, path)).second)
      fail(group, Message("one of its blocks is there twice"));
  }
  std::vector<PatchGrid> blocks;
  int faces = 0;
  for (auto& [first_face, block] : found) {
    if (first_face > faces)
      fail(group, Message("one of its blocks is missing: undo what removed it"));
    if (first_face < faces)
      fail(group,
           Message("one of its blocks has more rows or columns than before: undo that, and cut "
                   "its patches by Refine Here instead"));
    faces += int(block.patches.size());
    blocks.push_back(std::move(block));
  }
  if (blocks.empty()) fail(group, Message("it holds no blocks"));
  return blocks;
}

void set_opacities(const xmlNode* group, const std::vector<PatchGrid>& lights,
                   std::vector<PatchGrid>& blocks) {
  const auto same_shape = [](const PatchGrid& a, const PatchGrid& b) {
    return a.rows == b.rows && a.columns == b.columns;
  };
  if (!std::ranges::equal(lights, blocks, same_shape))
    fail(group, Message("its mask does not hold the opacities of all its blocks"));
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (std::size_t f = 0; f < blocks[b].patches.size(); ++f) {
      Patch& patch = blocks[b].patches[f];
      for (const int i : {0, 3})
        for (const int j : {0, 3})
          patch.c[i][j].color.a = mask_opacity(glm::dvec3(lights[b].patches[f].c[i][j].color));
      make_color_bilinear(patch);
    }
}

}  // namespace

bool is_mesh_group(const xmlNode* node) {
  return svg_name(node) == "g" && own_attribute(node, "version").has_value();
}

PaintRole group_role(const xmlNode* group) {
  if (own_attribute(group, "version") != "1")
    fail(group, Message("it was written by a newer gradmesh than this one"));
  return own_attribute(group, "role") == "stroke" ? PaintRole::stroke : PaintRole::fill;
}

MeshCounts counts_before(const xmlNode* group) {
  const auto patches = own_number(group, "patches-before");
  if (!patches) fail(group, Message("its gradmesh:patches-before is not a number"));
  return {own_number(group, "handles-before").value_or(0), *patches};
}

int block_count(const xmlNode* group) {
  int count = 0;
  for (const xmlNode* path : child_elements(group)) count += own_number(path, "face").has_value();
  return count;
}

bool is_opacity_mask(const xmlNode* node) {
  return svg_name(node) == "mask" && own_attribute(node, "opacity");
}

xmlNode* opacity_mask(const SvgDocument& document, const xmlNode* group) {
  const auto reference = attribute(group, "mask");
  const auto id = reference ? referenced_id(*reference) : std::nullopt;
  xmlNode* mask = id ? document.find(*id) : nullptr;
  return mask && is_opacity_mask(mask) ? mask : nullptr;
}

std::optional<BlockFaces> block_faces(const SvgDocument& document, const xmlNode* path) {
  const xmlNode* group = parent_element(path);
  const auto first = own_number(path, "face");
  if (!first || !group || !is_mesh_group(group)) return std::nullopt;
  const PatchGrid grid = read_mesh_gradient(document, block_gradient(document, group, path));
  return BlockFaces{*first, grid.rows, grid.columns};
}

std::vector<PatchGrid> read_mesh_blocks(const SvgDocument& document, const xmlNode* group) {
  std::vector<PatchGrid> blocks = read_blocks(document, group, group);
  if (const xmlNode* mask = opacity_mask(document, group))
    set_opacities(group, read_blocks(document, group, mask), blocks);
  return blocks;
}

MeshParts read_mesh_group(const SvgDocument& document, const xmlNode* group) {
  MeshParts parts = parts_of(read_mesh_blocks(document, group));
  const std::string text = own_attribute(group, "curves").value_or("");
  const auto curves = parse_curves(text);
  if (!curves) fail(group, Message("its gradmesh:curves cannot be read"));
  const int halfedges = 4 * int(parts.patches.size());
  for (const CurveParts& curve : *curves)
    for (const CurveSide* side : {&curve.a, &curve.b})
      for (const int h : side->halfedges)
        if (h < 0 || h >= halfedges)
          fail(group, Message("one of its blocks is missing: undo what removed it"));
  parts.curves.insert(parts.curves.end(), curves->begin(), curves->end());
  return parts;
}

}  // namespace gradmesh
