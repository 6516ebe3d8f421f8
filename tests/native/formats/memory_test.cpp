#include <gtest/gtest.h>

#include <algorithm>

#include "files/base64.h"
#include "files/zip.h"
#include "form/written_patch.h"
#include "formats/svg/read/document.h"
#include "formats/svg/read/read_group.h"
#include "formats/svg/write/memory.h"
#include "formats/svg/write/write_group.h"
#include "formats/svg/xml/node.h"
#include "mesh/build.h"
#include "mesh/color_model.h"
#include "random_meshes.h"
#include "same_mesh.h"

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

MeshParts random_grid(unsigned seed, ColorModel model = ColorModel::bilinear) {
  std::mt19937 random(seed);
  return test::grid_parts(
      {.rows = 4, .columns = 4, .position_noise = 0.08, .color_noise = 0.3, .color_model = model},
      random);
}

/// A mesh with T-junctions whose colours are no bytes and partly transparent.
Mesh random_mesh(unsigned seed) {
  MeshParts parts = random_grid(seed);
  for (Patch& patch : parts.patches) {
    for (const int i : {0, 3})
      for (const int j : {0, 3}) patch.c[i][j].color.a = patch.c[i][j].color.r;
    make_color_bilinear(patch);
  }
  return test::changed_mesh(parts, seed, 20);
}

/// The faces in the order in which blocks hold them.
std::vector<Patch> in_blocks(const Mesh& mesh, const std::vector<Rectangle>& blocks) {
  std::vector<Patch> list;
  for (const Rectangle& block : blocks)
    for (const Halfedge top : block.tops) list.push_back(patch_from(mesh, top));
  return list;
}

TEST(Memory, keeps_a_mesh_to_the_last_bits) {
  std::size_t junctions = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Mesh mesh = random_mesh(seed);
    const auto parts = recall(remember(mesh));
    ASSERT_TRUE(parts);
    const Mesh back = build_mesh(*parts);
    EXPECT_EQ(test::junctions(mesh), test::junctions(back));
    EXPECT_LE(difference_of(in_blocks(mesh, block_form(mesh, 0).blocks), patches(back)), 1e-10);
    junctions += test::junctions(mesh);
  }
  EXPECT_GT(junctions, 50u);
}

TEST(Memory, keeps_a_grid_in_its_order) {
  const Mesh mesh = build_mesh(random_grid(1));
  const auto parts = recall(remember(mesh));
  ASSERT_TRUE(parts);
  EXPECT_LE(difference_of(patches(mesh), parts->patches), 1e-10);
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
TEST(Memory, of_what_was_written_has_the_numbers_of_the_document) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    SvgDocument document = SvgDocument::parse(
        "<svg xmlns=\"http://www.w3.org/2000/svg\"><path id=\"p\" d=\"M0,0 H9 V9 Z\" "
        "fill=\"url(#m)\"/><meshgradient id=\"m\"/></svg>",
        "d.svg");
    const Mesh mesh = random_mesh(seed);
    write_mesh(document, mesh_objects(document).at(0),
               {mesh, block_form(mesh, 0.01), "", {49, 16}});
    const xmlNode* group = mesh_objects(document).at(0).node;
    const auto written = recall(*attribute(group, "written", gradmesh_namespace));
    ASSERT_TRUE(written);
    EXPECT_EQ(written->patches, read_mesh_group(document, group).patches) << "seed " << seed;
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
  // Sound, but no mesh.
  for (const char* text : {"", "<svg", "<html/>", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>",
                           "<svg xmlns=\"http://www.w3.org/2000/svg\"><g/></svg>", "HEMESH 1"})
    EXPECT_FALSE(recall(base64(zip(text)))) << text;
}

TEST(Memory, is_bounded_when_it_is_unpacked) {
  const std::string zeros = zip(std::string(1000, '\0'));
  EXPECT_EQ(unzip(zeros, 1000), std::string(1000, '\0'));
  EXPECT_EQ(unzip(zeros, 999), std::nullopt);
  EXPECT_EQ(unzip(zip(""), 0), "");
  // A sound mesh with a comment of blanks after it, which packs into nearly nothing.
  const auto with_blanks = [](std::size_t count) {
    const std::string text = *unzip(*base64_bytes(remember(random_mesh(1))), 1 << 20);
    return base64(zip(text + "<!--" + std::string(count, ' ') + "-->"));
  };
  EXPECT_TRUE(recall(with_blanks(1000)));
  EXPECT_FALSE(recall(with_blanks(2 << 20)));
}

/// What packs best of all that is honest: the bound is far from it.
TEST(Memory, of_many_equal_patches_is_kept) {
  std::mt19937 random(1);
  MeshParts white = test::grid_parts({.rows = 30, .columns = 30}, random);
  for (Patch& patch : white.patches) {
    for (const int i : {0, 3})
      for (const int j : {0, 3}) patch.c[i][j].color = glm::dvec4(1);
    make_color_bilinear(patch);
  }
  for (const MeshParts& kept : {white, as_bicubic(white)}) {
    const std::string memory = remember(build_mesh(kept));
    const std::size_t packed = base64_bytes(memory)->size();
    EXPECT_TRUE(unzip(*base64_bytes(memory), 30 * packed));
    const auto parts = recall(memory);
    ASSERT_TRUE(parts);
    EXPECT_EQ(parts->patches.size(), 900u);
  }
}

}  // namespace
}  // namespace gradmesh
