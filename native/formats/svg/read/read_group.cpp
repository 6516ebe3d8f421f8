#include "formats/svg/read/read_group.h"

#include <algorithm>
#include <charconv>
#include <map>

#include "form/written_patch.h"
#include "formats/svg/read/read_mesh.h"
#include "formats/svg/values/transform.h"
#include "formats/svg/xml/node.h"
#include "formats/text/excerpt.h"
#include "formats/text/number.h"

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

/// Reads the `curves` attribute; see formats/svg/read/read_group.h.
class CurveReader {
 public:
  CurveReader(const xmlNode* group, const std::string& text) : group_(group), rest_(text) {}

  std::vector<CurveParts> read() {
    std::vector<CurveParts> curves;
    skip_blanks();
    while (!rest_.empty()) {
      CurveParts curve;
      curve.a = side();
      expect('|');
      curve.b = side();
      curves.push_back(std::move(curve));
      if (!rest_.empty()) expect(';');
    }
    return curves;
  }

 private:
  CurveSide side() {
    CurveSide side;
    side.halfedges.push_back(number<int>());
    while (!rest_.empty() && rest_.front() != '|' && rest_.front() != ';') {
      side.breaks.push_back(number<double>());
      side.halfedges.push_back(number<int>());
    }
    return side;
  }

  template <class Number>
  Number number() {
    Number value{};
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc{}) fail(group_, Message("its gradmesh:curves cannot be read"));
    rest_.remove_prefix(std::size_t(end - rest_.data()));
    skip_blanks();
    return value;
  }

  void expect(char c) {
    if (rest_.empty() || rest_.front() != c)
      fail(group_, Message("its gradmesh:curves cannot be read"));
    rest_.remove_prefix(1);
    skip_blanks();
  }
  void skip_blanks() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
  }

  const xmlNode* group_;
  std::string_view rest_;
};

xmlNode* block_gradient(const SvgDocument& document, const xmlNode* group, const xmlNode* path) {
  const auto fill = document.styles().declared(path, "fill");
  xmlNode* gradient = fill ? referenced_mesh(document, *fill) : nullptr;
  if (!gradient) fail(group, Message("{0} has lost its mesh gradient", describe(path)));
  return gradient;
}

/// Returns a block's grid, in the group's user space.
MeshParts read_block(const SvgDocument& document, const xmlNode* group, xmlNode* path) {
  xmlNode* gradient = block_gradient(document, group, path);
  MeshParts block = read_mesh(document, {path, {}, PaintRole::fill, gradient});
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

void renumber(CurveSide& side, int first_face) {
  for (int& h : side.halfedges) h += 4 * first_face;
}

/// Returns the patches of all blocks below `parent`, the group or its mask, by their numbers, and
/// the curves inside each block.
MeshParts read_blocks(const SvgDocument& document, const xmlNode* group, const xmlNode* parent) {
  std::map<int, MeshParts> blocks;
  for (xmlNode* path : child_elements(parent)) {
    const auto face = own_number(path, "face");
    if (!face) continue;
    if (!blocks.emplace(*face, read_block(document, group, path)).second)
      fail(group, Message("one of its blocks is there twice"));
  }
  MeshParts parts;
  for (auto& [first_face, block] : blocks) {
    if (first_face != int(parts.patches.size()))
      fail(group, Message("one of its blocks is missing"));
    parts.patches.insert(parts.patches.end(), block.patches.begin(), block.patches.end());
    for (CurveParts& curve : block.curves) {
      renumber(curve.a, first_face);
      renumber(curve.b, first_face);
      parts.curves.push_back(std::move(curve));
    }
  }
  if (parts.patches.empty()) fail(group, Message("it holds no blocks"));
  return parts;
}

void set_opacities(const xmlNode* group, const MeshParts& lights, MeshParts& parts) {
  if (lights.patches.size() != parts.patches.size())
    fail(group, Message("its mask does not hold the opacities of all its blocks"));
  for (std::size_t f = 0; f < parts.patches.size(); ++f) {
    for (const int i : {0, 3})
      for (const int j : {0, 3})
        parts.patches[f].c[i][j].color.a =
            mask_opacity(glm::dvec3(lights.patches[f].c[i][j].color));
    make_color_bilinear(parts.patches[f]);
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
  const GradientPatches grid = read_mesh_gradient(document, block_gradient(document, group, path));
  return BlockFaces{*first, grid.rows, grid.columns};
}

MeshParts read_mesh_group(const SvgDocument& document, const xmlNode* group) {
  MeshParts parts = read_blocks(document, group, group);
  if (const xmlNode* mask = opacity_mask(document, group))
    set_opacities(group, read_blocks(document, group, mask), parts);

  const std::string text = own_attribute(group, "curves").value_or("");
  for (CurveParts& curve : CurveReader(group, text).read())
    parts.curves.push_back(std::move(curve));
  const int halfedges = 4 * int(parts.patches.size());
  for (const CurveParts& curve : parts.curves)
    for (const CurveSide* side : {&curve.a, &curve.b})
      for (const int h : side->halfedges)
        if (h < 0 || h >= halfedges) fail(group, Message("one of its blocks is missing"));
  return parts;
}

std::string format_curves(const Mesh& mesh, const std::vector<Rectangle>& blocks) {
  // Sides inside a block: a reader joins those by itself.
  std::vector<bool> inside;
  for (const Rectangle& block : blocks)
    for (int i = 0; i < block.rows; ++i)
      for (int j = 0; j < block.columns; ++j)
        for (const bool side : {i > 0, j + 1 < block.columns, i + 1 < block.rows, j > 0})
          inside.push_back(side);
  const auto format_side = [](const CurveSide& side) {
    std::string text = std::to_string(side.halfedges[0]);
    for (std::size_t i = 0; i < side.breaks.size(); ++i)
      text.append(" ")
          .append(format_exactly(side.breaks[i]))
          .append(" ")
          .append(std::to_string(side.halfedges[i + 1]));
    return text;
  };
  std::string text;
  for (const CurveParts& curve : block_parts(mesh, {blocks}).curves) {
    const bool whole = curve.a.breaks.empty() && curve.b.breaks.empty();
    if (whole && inside[std::size_t(curve.a.halfedges[0])]) continue;
    text += (text.empty() ? "" : "; ") + format_side(curve.a) + " | " + format_side(curve.b);
  }
  return text;
}

}  // namespace gradmesh
