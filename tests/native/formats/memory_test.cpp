#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "corners.h"
#include "files/base64.h"
#include "files/zip.h"
#include "form/handles.h"
#include "form/reconcile.h"
#include "form/written_patch.h"
#include "formats/svg/group/memory.h"
#include "formats/svg/group/mesh_group.h"
#include "formats/svg/group/write_group.h"
#include "formats/svg/tree/own.h"
#include "mesh/boundary.h"
#include "mesh/build.h"
#include "mesh/color_model.h"
#include "random_meshes.h"
#include "same_mesh.h"
#include "svg_documents.h"

namespace gradmesh {
namespace {

using test::difference;
using test::patches;

double difference_of(const std::vector<Patch>& a, const std::vector<Patch>& b) {
  EXPECT_EQ(a.size(), b.size());
  double most = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    most = std::max(most, difference(a[i], b[i]));
  return most;
}

double width(const Mesh& mesh) {
  const glm::dvec2 size = bounding_box(mesh, {}).size();
  return std::max(size.x, size.y);
}

MeshParts random_grid(unsigned seed, ColorModel model = ColorModel::bilinear) {
  std::mt19937 random(seed);
  return test::grid_parts(
      {.rows = 4, .columns = 4, .position_noise = 0.08, .color_noise = 0.3, .color_model = model},
      random);
}

/// A mesh with T-junctions whose colours are no bytes and partly transparent.
Mesh random_mesh(unsigned seed) {
  MeshParts parts = random_grid(seed);
  test::change_corners(parts, [](Value& v) { v.color.a = v.color.r; });
  return test::changed_mesh(parts, seed, 20);
}

/// The faces in the order in which blocks hold them.
std::vector<Patch> in_blocks(const Mesh& mesh, const std::vector<Rectangle>& blocks) {
  std::vector<Patch> list;
  for (const Rectangle& block : blocks)
    for (const Halfedge top : block.tops) list.push_back(mesh.patch(top));
  return list;
}

/// The largest distance of a number of a patch, a twist at most, from that of the mesh of 4 x 4
/// units or so that is remembered.
double rounding(double width) { return 9 * 9 * width / (1 << 18); }

/// A document with the mesh in blocks of this tolerance.
SvgTree group_of(const Mesh& mesh, double tolerance) {
  SvgTree document =
      test::svg_tree("<path id='p' d='M0,0 H9 V9 Z' fill='url(#m)'/><meshgradient id='m'/>");
  write_group(document, mesh_objects(document).at(0),
              {mesh, block_form(mesh, tolerance), "", {49, 16}});
  return document;
}

/// What gradmesh 0.1 has written: a document with a group.
std::string older_memory(const Mesh& mesh, const std::string& end = "") {
  return base64(pack_zlib(group_of(mesh, 0).serialize() + end));
}

TEST(Memory, keeps_a_mesh_but_for_rounding) {
  std::size_t junctions = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Mesh mesh = random_mesh(seed);
    const auto parts = recall(remember(mesh));
    ASSERT_TRUE(parts);
    const Mesh back = build_mesh(*parts);
    EXPECT_EQ(test::junctions(mesh), test::junctions(back));
    EXPECT_LE(difference_of(in_blocks(mesh, block_form(mesh, 0).blocks), patches(back)),
              rounding(width(mesh)));
    junctions += test::junctions(mesh);
  }
  EXPECT_GT(junctions, 50u);
}

TEST(Memory, keeps_a_grid_in_its_order) {
  const Mesh mesh = build_mesh(random_grid(1));
  const auto parts = recall(remember(mesh));
  ASSERT_TRUE(parts);
  EXPECT_LE(difference_of(patches(mesh), parts->patches), rounding(width(mesh)));
  // Remembered again nothing is lost.
  EXPECT_EQ(remember(build_mesh(*parts)), remember(mesh));
}

TEST(Memory, keeps_straight_sides_coons_patches_and_8_bits) {
  std::mt19937 random(3);
  MeshParts grid = test::grid_parts({.rows = 3, .columns = 3}, random);
  test::change_corners(grid, [](Value& v) { v.color = glm::round(255.0 * v.color) / 255.0; });
  for (Patch& patch : grid.patches) patch = as_written(patch, 1e9);
  grid.smooth = true;
  const auto parts = recall(remember(build_mesh(grid)));
  ASSERT_TRUE(parts);
  EXPECT_TRUE(parts->smooth);
  for (std::size_t f = 0; f < grid.patches.size(); ++f) {
    EXPECT_FALSE(needs_tensor(parts->patches[f], 1e-12));
    for (int k = 0; k < 4; ++k) {
      EXPECT_TRUE(is_straight(parts->patches[f].side(k), 1e-12));
      EXPECT_EQ(parts->patches[f].corner(k).color, grid.patches[f].corner(k).color);
    }
  }
}

TEST(Memory, takes_a_mesh_of_any_size_and_place) {
  for (const auto& [size, place] : {std::pair(glm::dvec2(1e-6), glm::dvec2(0)),
                                    {glm::dvec2(1e6), glm::dvec2(-4e8, 3e8)},
                                    {glm::dvec2(1e-3, 1e3), glm::dvec2(7, -9)},
                                    {glm::dvec2(1), glm::dvec2(1e5)}}) {
    MeshParts grid = random_grid(5);
    transform(grid, Affine::translation(place) * Affine::scaling(size));
    auto parts = recall(remember(build_mesh(grid)));
    ASSERT_TRUE(parts);
    transform(*parts, Affine::scaling(1.0 / size) * Affine::translation(-place));
    EXPECT_LE(difference_of(random_grid(5).patches, parts->patches), rounding(1000));
  }
}

TEST(Memory, of_older_versions_can_be_recalled) {
  const Mesh mesh = random_mesh(4);
  const auto parts = recall(older_memory(mesh));
  const auto blocks = recall_blocks(older_memory(mesh));
  ASSERT_TRUE(parts && blocks);
  EXPECT_EQ(test::junctions(build_mesh(*parts)), test::junctions(mesh));
  EXPECT_EQ(parts->patches, parts_of(*blocks).patches);
  EXPECT_LT(remember(mesh).size(), older_memory(mesh).size() / 3);
}

TEST(Memory, keeps_bicubic_colours) {
  const Mesh mesh =
      test::without_own_tangents(test::changed_mesh(random_grid(2, ColorModel::bicubic), 2, 20));
  const auto parts = recall(remember(mesh));
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->color_model, ColorModel::bicubic);
  const Mesh back = build_mesh(*parts);
  const std::vector<Patch> there = patches(mesh), here = patches(back);
  ASSERT_EQ(there.size(), here.size());
  for (std::size_t i = 0; i < there.size(); ++i)
    EXPECT_LE(difference(test::solid(there[i]), test::solid(here[i])), 1e-10);
}

/// What the document says that was written, and what the group remembers of it.
TEST(Memory, of_what_was_written_is_finer_than_what_counts_as_an_edit) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    SvgTree document = group_of(random_mesh(seed), 0.01);
    const xmlNode* group = mesh_objects(document).at(0).node;
    const auto blocks = recall_blocks(*own_attribute(group, "written"));
    ASSERT_TRUE(blocks);
    const MeshParts read = read_mesh_group(document, group);
    MeshParts written = parts_of(*blocks);
    written.curves = read.curves;
    EXPECT_FALSE(reconcile(read, written).edited) << "seed " << seed;
  }
}

TEST(Memory, remembers_nothing_where_it_is_damaged) {
  const std::string memory = remember(random_mesh(1));
  ASSERT_TRUE(recall(memory));
  for (std::size_t i = 0; i < memory.size(); i += 7) {
    std::string changed = memory;
    changed[i] = changed[i] == 'A' ? 'B' : 'A';
    EXPECT_FALSE(recall(changed)) << "at " << i;
    EXPECT_FALSE(recall(memory.substr(0, i))) << "cut at " << i;
  }
  // A digit for another moves four bytes, to which sums of bytes may be blind.
  for (const char digit : std::string("0159AZaz!#()*+,-./:;=?@[]^_{|}"))
    for (std::size_t i = 0; i < memory.size(); i += 11) {
      std::string changed = memory;
      changed[i] = digit;
      EXPECT_EQ(recall(changed).has_value(), changed == memory) << digit << " at " << i;
    }
  // Sound, but no mesh.
  for (const char* text : {"", "<svg", "<html/>", "<svg xmlns='http://www.w3.org/2000/svg'/>",
                           "<svg xmlns='http://www.w3.org/2000/svg'><g/></svg>", "HEMESH 1"})
    EXPECT_FALSE(recall(base64(pack_zlib(text)))) << text;
}

TEST(Memory, is_bounded_when_it_is_unpacked) {
  const std::string zeros = pack_zlib(std::string(1000, '\0'));
  EXPECT_EQ(unpack_zlib(zeros, 1000), std::string(1000, '\0'));
  EXPECT_EQ(unpack_zlib(zeros, 999), std::nullopt);
  EXPECT_EQ(unpack_zlib(pack_zlib(""), 0), "");
  // A sound mesh with a comment of blanks after it, which packs into nearly nothing.
  const auto with_blanks = [](std::size_t count) {
    return older_memory(random_mesh(1), "<!--" + std::string(count, ' ') + "-->");
  };
  EXPECT_TRUE(recall(with_blanks(1000)));
  EXPECT_FALSE(recall(with_blanks(4 << 20)));
}

/// What packs best of all that is honest: the bound is far from it.
TEST(Memory, of_many_equal_patches_is_kept) {
  for (const bool is_bicubic : {false, true}) {
    const int rows = is_bicubic ? 30 : 140;
    std::mt19937 random(1);
    MeshParts white = test::grid_parts({.rows = rows, .columns = rows}, random);
    test::change_corners(white, [](Value& v) { v.color = glm::dvec4(1); });
    const auto parts = recall(remember(build_mesh(is_bicubic ? as_bicubic(white) : white)));
    ASSERT_TRUE(parts);
    EXPECT_EQ(parts->patches.size(), white.patches.size());
  }
}

}  // namespace
}  // namespace gradmesh
