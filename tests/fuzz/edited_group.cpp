#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "branch_meshes.h"
#include "choices.h"
#include "formats/svg/group/mesh_group.h"
#include "formats/svg/tree/svg_tree.h"
#include "formats/svg/values/curves.h"
#include "formats/svg/xml/node.h"
#include "formats/text/number.h"
#include "mesh/build.h"
#include "ops/split/without_faces.h"
#include "target.h"
#include "written_blocks.h"

namespace gradmesh::fuzz {
namespace {

/// A group of blocks as it was written.
struct Written {
  std::vector<PatchGrid> blocks;
  std::string curves;
};

Written written(const MeshParts& parts) {
  const Mesh mesh = build_mesh(parts);
  return {test::written_blocks(parts).written, format_curves(mesh, block_form(mesh, 0).blocks)};
}

MeshParts parts_in_pixels(MeshParts parts, unsigned seed) {
  transform(parts, Affine::scaling({100, 100}));
  return test::written_parts(std::move(parts), seed, 8);
}

/// Groups with T-junctions, and some that close around holes.
const std::vector<Written>& groups() {
  static const std::vector<Written> known = [] {
    std::vector<Written> groups;
    for (unsigned seed = 0; seed < 12; ++seed) groups.push_back(written(test::written_parts(seed)));
    groups.push_back(written(parts_in_pixels(test::ring(5), 1)));
    groups.push_back(written(parts_in_pixels(test::ring(5), 2)));
    groups.push_back(written(parts_in_pixels(test::dumbbell(), 3)));
    groups.push_back(written(parts_in_pixels(test::u_branch(), 4)));
    return groups;
  }();
  return known;
}

/// A block as a person leaves it: its patches, the transform of its path, and its face's number,
/// which nobody edits but a fault may.
struct Block {
  PatchGrid grid;
  std::string transform;
  int face = 0;
};

class Edits {
 public:
  Edits(const Written& written, Choices& choices) : choices_(choices) {
    int face = 0;
    for (const PatchGrid& grid : written.blocks) {
      blocks_.push_back({grid, "", face});
      face += int(grid.patches.size());
    }
  }

  void next() {
    const unsigned which = choices_.byte() % 12;
    if (blocks_.empty()) return;
    const std::size_t at = choices_.below(blocks_.size());
    Block& block = blocks_[at];
    if (which < 3) return cut_somewhere(block.grid);
    if (which == 3) return move_corner(block.grid);
    if (which == 4) return move_handle(block.grid);
    if (which == 5) return recolor(block.grid);
    if (which == 6) return transform_path(block);
    if (which == 7) return transform_patches(block.grid);
    if (which == 8) blocks_.erase(blocks_.begin() + std::ptrdiff_t(at));
    if (which == 9) block.face = int(choices_.byte());
    if (which == 10) take_out_last_row(block.grid);
    if (which == 11) block.grid = blocks_[choices_.below(blocks_.size())].grid;
  }

  const std::vector<Block>& blocks() const { return blocks_; }

 private:
  static constexpr std::size_t many_patches = 60;

  double offset() { return (double(choices_.byte()) - 128) / 4; }

  void cut_somewhere(PatchGrid& grid) {
    BlockCuts cuts{std::vector<std::vector<double>>(std::size_t(grid.rows)),
                   std::vector<std::vector<double>>(std::size_t(grid.columns))};
    auto& lines = choices_.byte() % 2 ? cuts.rows : cuts.columns;
    lines[choices_.below(lines.size())] = {choices_.share()};
    if (grid.patches.size() < many_patches) grid = cut(grid, cuts);
  }

  /// Moves a corner of one patch alone, or, as the mesh tool does, in all patches of the block.
  void move_corner(PatchGrid& grid) {
    const bool alone = choices_.byte() % 4 == 0;
    const std::size_t f = choices_.below(grid.patches.size());
    const unsigned corner = choices_.byte() % 4;
    const glm::dvec2 at = grid.patches[f].corner(int(corner)).position, by{offset(), offset()};
    for (std::size_t i = 0; i < grid.patches.size(); ++i) {
      if (alone && i != f) continue;
      BezierNet net = bezier_net(grid.patches[i]);
      for (const int u : {0, 3})
        for (const int v : {0, 3})
          if (net[u][v].position == at) net[u][v].position += by;
      grid.patches[i] = patch_from_bezier(net);
    }
  }

  void move_handle(PatchGrid& grid) {
    Patch& patch = grid.patches[choices_.below(grid.patches.size())];
    BezierNet net = bezier_net(patch);
    net[choices_.byte() % 4][choices_.byte() % 4].position += glm::dvec2{offset(), offset()};
    patch = patch_from_bezier(net);
  }

  void recolor(PatchGrid& grid) {
    Patch& patch = grid.patches[choices_.below(grid.patches.size())];
    const unsigned corner = choices_.byte();
    const double grey = choices_.byte() / 255.0;
    patch.c[corner % 2 ? 3 : 0][corner / 2 % 2 ? 3 : 0].color = {grey, 1 - grey, grey,
                                                                 choices_.byte() / 255.0};
    make_color_bilinear(patch);
  }

  void transform_path(Block& block) {
    static constexpr const char* transforms[] = {
        "scale(2)",     "scale(-1 1)",         "rotate(30)",   "translate(20 -9)", "scale(0)",
        "scale(1e-12)", "matrix(1 0 0 0 0 0)", "scale(1e300)", "scale(1e7)",       "turn(1)"};
    block.transform = transforms[choices_.below(std::size(transforms))];
  }

  void transform_patches(PatchGrid& grid) {
    const double size = choices_.byte() / 64.0, shear = offset() / 16;
    const Affine by{glm::dmat2(size, shear, -shear, size), {offset(), offset()}};
    for (Patch& patch : grid.patches) transform(patch, by);
  }

  static void take_out_last_row(PatchGrid& grid) {
    if (grid.rows == 1) return;
    --grid.rows;
    grid.patches.resize(std::size_t(grid.rows * grid.columns));
  }

  std::vector<Block> blocks_;
  Choices& choices_;
};

std::string point(const Value& v) { return format_point(v.position); }

/// Returns `meshpatch` elements in rows, with absolute sides and, of each patch, those that no
/// patch before has given.
std::string rows_text(const PatchGrid& grid) {
  std::string text;
  for (int i = 0; i < grid.rows; ++i) {
    text += "<meshrow>";
    for (int j = 0; j < grid.columns; ++j) {
      const Patch& patch = grid.patches[std::size_t(i * grid.columns + j)];
      const BezierNet net = bezier_net(patch);
      const auto inside = [&](int u, int v) {
        return format_point(net[u][v].position - net[u == 1 ? 0 : 3][v == 1 ? 0 : 3].position);
      };
      text += "<meshpatch tensor='" + inside(1, 1) + " " + inside(1, 2) + " " + inside(2, 2) + " " +
              inside(2, 1) + "'>";
      for (int k = 0; k < 4; ++k) {
        if ((k == 0 && i > 0) || (k == 3 && j > 0)) continue;
        const Cubic<Value> side = patch.side(k);
        const glm::dvec4 color = glm::clamp(side.p0.color, 0.0, 1.0);
        text += "<stop path='C " + point(side.bezier1()) + " " + point(side.bezier2()) + " " +
                point(side.p1) + "' stop-color='rgb(";
        for (int c = 0; c < 3; ++c)
          text += std::to_string(std::lround(255 * color[c])) + (c < 2 ? "," : ")'");
        text += " stop-opacity='" + format_number(color.a) + "'/>";
      }
      text += "</meshpatch>";
    }
    text += "</meshrow>";
  }
  return text;
}

/// Returns the blocks' gradients and paths.
std::pair<std::string, std::string> texts(const std::vector<Block>& blocks,
                                          const std::string& name) {
  std::pair<std::string, std::string> texts;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const auto& [grid, transform, face] = blocks[b];
    const Value start = grid.patches.front().corner(0);
    const std::string id = name + std::to_string(b);
    texts.first += "<meshgradient id='" + id + "' gradientUnits='userSpaceOnUse' x='" +
                   format_number(start.position.x) + "' y='" + format_number(start.position.y) +
                   "'>" + rows_text(grid) + "</meshgradient>";
    texts.second += "<path id='p" + id + "' gradmesh:face='" + std::to_string(face) +
                    "' fill='url(#" + id + ")'" +
                    (transform.empty() ? "" : " transform='" + transform + "'") + "/>";
  }
  return texts;
}

SvgTree document(const Written& written, const std::vector<Block>& blocks,
                 const std::vector<Block>* mask) {
  const auto [gradients, paths] = texts(blocks, "b");
  std::string defs = gradients;
  if (mask) {
    const auto [lights, light_paths] = texts(*mask, "m");
    defs += lights + "<mask id='mask' gradmesh:opacity='1'>" + light_paths + "</mask>";
  }
  return SvgTree::parse(
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:gradmesh='urn:gradmesh'><defs>" + defs +
          "</defs><g id='g' gradmesh:version='1' gradmesh:curves='" + written.curves + "'" +
          (mask ? " mask='url(#mask)'" : "") + ">" + paths + "</g></svg>",
      input_name);
}

/// Returns the group as Update finds it: whether it was edited.
bool update(const SvgTree& document, const std::vector<PatchGrid>& written) {
  const xmlNode* const group = child_elements(document.root(), "g").front();
  const EditedBlocks blocks = read_edited_group(document, group, written);
  const Reconciled whole = reconcile(blocks);
  Mesh mesh = build_mesh(whole.parts);
  require_sound(mesh);
  std::vector<Face> removed;
  for (const int patch : removed_patches(blocks)) removed.push_back(Face{patch});
  if (!removed.empty()) mesh = without_faces(std::move(mesh), removed);
  require_sound(mesh);
  must_accept(
      [&] {
        const BlockForm form = block_form(mesh, 0);
        const Mesh again = build_mesh(block_parts(mesh, form));
        require_sound(again);
        require(again.face_count() == mesh.face_count(), "no patch is lost");
      },
      "a mesh that was updated can be written");
  return whole.edited || !removed.empty();
}

/// How the blocks were written, as the group remembers it: not at all, or that of another group.
const std::vector<PatchGrid>& remembered(const Written& written, Choices& choices) {
  static const std::vector<PatchGrid> nothing;
  switch (choices.byte() % 16) {
    case 1:
      return nothing;
    case 2:
      return groups()[choices.below(groups().size())].blocks;
    default:
      return written.blocks;
  }
}

}  // namespace

void check(std::string_view bytes) {
  Choices choices(bytes);
  const Written& written = groups()[choices.below(groups().size())];
  const std::vector<PatchGrid>& known = remembered(written, choices);
  const bool has_mask = choices.byte() % 4 == 1, stays = choices.at_end();
  Edits edits(written, choices), lights(written, choices);
  while (!choices.at_end()) (has_mask && choices.byte() % 8 == 1 ? lights : edits).next();
  const auto read = [&] {
    const SvgTree edited = document(written, edits.blocks(), has_mask ? &lights.blocks() : nullptr);
    const bool is_edited = update(edited, known);
    require(!stays || has_mask || &known != &written.blocks || !is_edited,
            "a group is as it was written");
  };
  if (stays && &known == &written.blocks && !has_mask)
    must_accept(read, "a group that nobody has edited can be read");
  else
    accepts(read);
}

}  // namespace gradmesh::fuzz
