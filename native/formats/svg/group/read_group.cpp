#include <algorithm>
#include <charconv>

#include "base/error.h"
#include "form/written_patch.h"
#include "formats/svg/gradient/mesh_gradient.h"
#include "formats/svg/gradient/rows.h"
#include "formats/svg/group/memory.h"
#include "formats/svg/group/mesh_group.h"
#include "formats/svg/tree/own.h"
#include "formats/svg/values/curves.h"
#include "formats/svg/values/transform.h"
#include "formats/svg/xml/node.h"
#include "formats/text/excerpt.h"

namespace gradmesh {
namespace {

std::optional<int> own_number(const xmlNode* node, const char* name) {
  const auto text = own_attribute(node, name);
  int value = 0;
  if (!text) return std::nullopt;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
  if (error != std::errc{} || end != text->data() + text->size() || value < 0) return std::nullopt;
  return value;
}

xmlNode* block_gradient(const SvgTree& tree, const xmlNode* group, const xmlNode* path) {
  xmlNode* gradient = referenced_mesh(tree, tree.styles().declared(path, "fill"));
  if (!gradient) fail(group, Message("{0} has lost its mesh gradient", describe(path)));
  return gradient;
}

/// Returns a block's grid, in the group's user space.
PatchGrid read_block(const SvgTree& tree, const xmlNode* group, xmlNode* path) {
  xmlNode* gradient = block_gradient(tree, group, path);
  PatchGrid block = read_mesh_patches(tree, {path, {}, PaintRole::fill, gradient});
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

/// The blocks below a group or its mask, by the number of their first face as it was written.
using NumberedBlocks = std::map<int, PatchGrid>;

NumberedBlocks numbered_blocks(const SvgTree& tree, const xmlNode* group, const xmlNode* parent) {
  NumberedBlocks blocks;
  for (xmlNode* path : child_elements(parent)) {
    const auto face = own_number(path, "face");
    if (!face) continue;
    if (!blocks.emplace(*face, read_block(tree, group, path)).second)
      fail(group, Message("one of its blocks is there twice"));
  }
  if (blocks.empty()) fail(group, Message("it holds no blocks"));
  return blocks;
}

Message is_missing() { return Message("one of its blocks is missing: undo what removed it"); }

/// Returns the blocks in the order of their faces, of which none is missing.
std::vector<PatchGrid> read_blocks(const SvgTree& tree, const xmlNode* group,
                                   const xmlNode* parent) {
  std::vector<PatchGrid> blocks;
  int faces = 0;
  for (auto& [first_face, block] : numbered_blocks(tree, group, parent)) {
    if (first_face > faces) fail(group, is_missing());
    if (first_face < faces)
      fail(group,
           Message("one of its blocks has more rows or columns than before: undo that, and cut "
                   "its patches by Refine Here instead"));
    faces += int(block.patches.size());
    blocks.push_back(block);
  }
  return blocks;
}

bool have_same_shape(const PatchGrid& a, const PatchGrid& b) {
  return a.rows == b.rows && a.columns == b.columns;
}

void set_opacities(const xmlNode* group, const PatchGrid& lights, PatchGrid& block) {
  if (!have_same_shape(lights, block))
    fail(group, Message("its mask does not hold the opacities of all its blocks"));
  for (std::size_t f = 0; f < block.patches.size(); ++f) {
    Patch& patch = block.patches[f];
    for (const int i : {0, 3})
      for (const int j : {0, 3})
        patch.c[i][j].color.a = mask_opacity(glm::dvec3(lights.patches[f].c[i][j].color));
    make_color_bilinear(patch);
  }
}

std::size_t patch_count(const std::vector<PatchGrid>& blocks) {
  std::size_t count = 0;
  for (const PatchGrid& block : blocks) count += block.patches.size();
  return count;
}

/// Returns the curves with more than one block along them, of a mesh of so many patches.
std::vector<CurveParts> group_curves(const xmlNode* group, std::size_t patches) {
  auto curves = parse_curves(own_attribute(group, "curves").value_or(""));
  if (!curves) fail(group, Message("its gradmesh:curves cannot be read"));
  for (const CurveParts& curve : *curves)
    for (const CurveSide* side : {&curve.a, &curve.b})
      for (const int h : side->halfedges)
        if (h < 0 || h >= 4 * int(patches)) fail(group, is_missing());
  return std::move(*curves);
}

/// Returns the blocks as they were written by the numbers of their first faces, if the group can be
/// what a person has left of them.
std::optional<NumberedBlocks> fitting(const std::vector<PatchGrid>& written,
                                      const NumberedBlocks& found) {
  NumberedBlocks before;
  int faces = 0;
  for (const PatchGrid& block : written) {
    before.emplace(faces, block);
    faces += int(block.patches.size());
  }
  const bool fits = std::ranges::all_of(
      found, [&](const auto& numbered) { return before.contains(numbered.first); });
  return fits ? std::optional(before) : std::nullopt;
}

/// Returns how the block with the first face `face` was cut since it was written.
BlockCuts cuts_of(const xmlNode* group, int face, const PatchGrid& before, const PatchGrid& now) {
  const auto fail_block = [&](const Message& why) {
    for (const xmlNode* path : child_elements(group))
      if (own_number(path, "face") == face) fail(path, why);
    fail(group, why);
  };
  if (now.rows < before.rows || now.columns < before.columns)
    fail_block(Message("it has fewer rows or columns than before: undo that"));
  const auto cuts = find_cuts(before, now);
  if (!cuts)
    fail_block(
        Message("gradmesh cannot tell which of its rows or columns are new: undo what moved the "
                "others, or cut its patches by Refine Here instead"));
  return *cuts;
}

}  // namespace

MeshCounts counts_before(const MeshObject& group) {
  const auto patches = own_number(group.node, "patches-before");
  if (!patches) fail(group.node, Message("its gradmesh:patches-before is not a number"));
  return {own_number(group.node, "handles-before").value_or(0), *patches};
}

int block_count(const MeshObject& group) {
  const auto is_numbered = [](const xmlNode* path) { return own_number(path, "face").has_value(); };
  return int(std::ranges::count_if(child_elements(group.node), is_numbered));
}

std::map<const xmlNode*, BlockFaces> block_faces(const SvgTree& tree, const xmlNode* group) {
  std::map<int, std::pair<const xmlNode*, PatchGrid>> found;
  for (const xmlNode* path : child_elements(group))
    if (const auto face = own_number(path, "face"))
      found.emplace(*face,
                    std::pair(path, read_mesh_gradient(tree, block_gradient(tree, group, path))));
  std::map<const xmlNode*, BlockFaces> faces;
  int first = 0;
  for (const auto& [face, block] : found) {
    const auto& [path, grid] = block;
    faces[path] = {first, grid.rows, grid.columns};
    first += int(grid.patches.size());
  }
  return faces;
}

ChosenBlock find_block(const SvgTree& tree, const std::vector<MeshObject>& objects,
                       const std::string& id) {
  const xmlNode* path = tree.find(id);
  if (!path) throw InputError("{0}: there is no object with the id {1}.", tree.name(), excerpt(id));
  const xmlNode* group = parent_element(path);
  const auto blocks = group && is_mesh_group(group) ? block_faces(tree, group)
                                                    : std::map<const xmlNode*, BlockFaces>();
  const auto found = blocks.find(path);
  const auto object = std::ranges::find(objects, group, &MeshObject::node);
  if (is_mesh_group(path))
    fail(path, Message("it is a whole simplified mesh: double-click it, then select its blocks"));
  if (found == blocks.end() || object == objects.end())
    fail(path, Message("it is no block of a simplified mesh"));
  ChosenBlock block{std::size_t(object - objects.begin()), found->second, 0};
  for (const auto& [other, faces] : blocks) block.faces_of_all += faces.rows * faces.columns;
  return block;
}

std::vector<PatchGrid> read_mesh_blocks(const SvgTree& tree, const xmlNode* group) {
  std::vector<PatchGrid> blocks = read_blocks(tree, group, group);
  const xmlNode* mask = opacity_mask(tree, group);
  if (!mask) return blocks;
  const std::vector<PatchGrid> lights = read_blocks(tree, group, mask);
  for (std::size_t b = 0; b < blocks.size(); ++b)
    set_opacities(group, b < lights.size() ? lights[b] : PatchGrid(), blocks[b]);
  return blocks;
}

MeshParts read_mesh_group(const SvgTree& tree, const xmlNode* group) {
  const std::vector<PatchGrid> blocks = read_mesh_blocks(tree, group);
  return parts_of(blocks, group_curves(group, patch_count(blocks)));
}

EditedBlocks read_edited_group(const SvgTree& tree, const MeshObject& group) {
  const auto memory = own_attribute(group.node, "written");
  const auto written = memory ? recall_blocks(*memory) : std::nullopt;
  return read_edited_group(tree, group.node, written.value_or(std::vector<PatchGrid>()));
}

EditedBlocks read_edited_group(const SvgTree& tree, const xmlNode* group,
                               const std::vector<PatchGrid>& written) {
  EditedBlocks edited;
  const NumberedBlocks found = numbered_blocks(tree, group, group);
  const auto before = fitting(written, found);
  if (!before) {
    edited.read = read_mesh_blocks(tree, group);
    edited.curves = group_curves(group, patch_count(edited.read));
    return edited;
  }
  edited.curves = group_curves(group, patch_count(written));
  const xmlNode* mask = opacity_mask(tree, group);
  const NumberedBlocks lights = mask ? numbered_blocks(tree, group, mask) : NumberedBlocks();
  edited.written = written;
  for (const auto& [face, block] : *before) {
    const auto now = found.find(face);
    edited.removed.push_back(now == found.end());
    edited.read.push_back(edited.removed.back() ? block : now->second);
    edited.cuts.push_back(cuts_of(group, face, block, edited.read.back()));
    if (!mask || edited.removed.back()) continue;
    const auto light = lights.find(face);
    const bool lit = light != lights.end() && have_same_shape(light->second, block);
    set_opacities(group, lit ? cut(light->second, edited.cuts.back()) : PatchGrid(),
                  edited.read.back());
  }
  return edited;
}

}  // namespace gradmesh
