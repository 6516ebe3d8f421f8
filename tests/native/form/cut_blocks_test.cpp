#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "branch_meshes.h"
#include "form/written_patch.h"
#include "mesh/validate.h"
#include "ops/split/without_faces.h"
#include "same_mesh.h"
#include "written_blocks.h"

/// Meshes of 400 x 400 units, so that 0.006 units are within the rounding.
namespace gradmesh {
namespace {

using test::difference;

EditedBlocks random_blocks(unsigned seed) {
  return test::written_blocks(test::written_parts(seed));
}

double at_random(std::mt19937& random) { return 0.1 + 0.8 * double(random() % 1000) / 1000; }

/// Cuts some rows and columns of some blocks, the first in any case, some twice.
void cut_at_random(EditedBlocks& blocks, std::mt19937& random) {
  for (std::size_t b = 0; b < blocks.read.size(); ++b) {
    if (b > 0 && random() % 3 > 0) continue;
    for (auto* const lines : {&blocks.cuts[b].rows, &blocks.cuts[b].columns}) {
      if (lines == &blocks.cuts[b].columns && random() % 2) continue;
      std::vector<double>& places = (*lines)[random() % lines->size()];
      places.push_back(at_random(random));
      if (random() % 3 == 0) places.push_back(at_random(random));
      std::ranges::sort(places);
      if (places.size() == 2 && places[1] - places[0] < 0.05) places.pop_back();
    }
    blocks.read[b] = cut(blocks.written[b], blocks.cuts[b]);
  }
}

/// Rounds as Inkscape writes: eight digits relative to the point before, and colours to 8 bits.
void round_as_written(std::vector<PatchGrid>& blocks, std::mt19937& random) {
  std::uniform_real_distribution<double> rounding(-1e-5, 1e-5);
  for (PatchGrid& block : blocks)
    for (Patch& patch : block.patches) {
      patch = as_written(patch, 0);
      for (auto& row : patch.c)
        for (Value& v : row) v.position += glm::dvec2{rounding(random), rounding(random)};
    }
}

void expect_places(const std::vector<std::vector<double>>& found,
                   const std::vector<std::vector<double>>& cuts, double tolerance) {
  ASSERT_EQ(found.size(), cuts.size());
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    ASSERT_EQ(found[i].size(), cuts[i].size());
    for (std::size_t k = 0; k < cuts[i].size(); ++k)
      EXPECT_NEAR(found[i][k], cuts[i][k], tolerance);
  }
}

/// Replaces the cuts by those that are found. Returns false if some cannot be told.
bool find(EditedBlocks& blocks, double tolerance) {
  for (std::size_t b = 0; b < blocks.read.size(); ++b) {
    const auto found = find_cuts(blocks.written[b], blocks.read[b]);
    if (!found) return false;
    expect_places(found->rows, blocks.cuts[b].rows, tolerance);
    expect_places(found->columns, blocks.cuts[b].columns, tolerance);
    blocks.cuts[b] = *found;
  }
  return true;
}

TEST(CutBlocks, cuts_at_random_change_no_color) {
  std::size_t before = 0, after = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    EditedBlocks blocks = random_blocks(seed);
    before += test::junctions(build_mesh(reconcile(blocks).parts));
    EXPECT_FALSE(reconcile(blocks).edited);
    cut_at_random(blocks, random);
    round_as_written(blocks.read, random);
    ASSERT_TRUE(find(blocks, 1e-4));
    const Reconciled result = reconcile(blocks);
    EXPECT_TRUE(result.edited);
    const Mesh mesh = build_mesh(result.parts);
    ASSERT_EQ(validate(mesh), std::vector<std::string>{});
    const std::vector<Patch> read = parts_of(blocks.read).patches;
    ASSERT_EQ(std::size_t(mesh.face_count()), read.size());
    for (const Face f : mesh.faces())
      // Nine times what counts as no edit, in a twist.
      EXPECT_LE(difference(mesh.patch(f), read[std::size_t(f.value)]), 0.06);
    after += test::junctions(mesh);
  }
  EXPECT_GT(after, before + 300);
}

/// Moves a corner with its handles as the mesh tool does, in all patches of the block that have it.
void move_corner(PatchGrid& block, int row, int column, glm::dvec2 by) {
  for (int i = std::max(row - 1, 0); i <= std::min(row, block.rows - 1); ++i)
    for (int j = std::max(column - 1, 0); j <= std::min(column, block.columns - 1); ++j) {
      Patch& patch = block.patches[std::size_t(i * block.columns + j)];
      BezierNet net = bezier_net(patch);
      const int u = i < row ? 3 : 0, v = j < column ? 3 : 0;
      for (const int du : {u, u ? 2 : 1})
        for (const int dv : {v, v ? 2 : 1}) net[du][dv].position += by;
      patch = patch_from_bezier(net);
    }
}

TEST(CutBlocks, corners_that_were_moved_since_are_where_they_were_put) {
  int moved = 0, unclear = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    EditedBlocks blocks = random_blocks(seed);
    cut_at_random(blocks, random);
    round_as_written(blocks.read, random);
    PatchGrid& block = blocks.read[0];
    const int row = int(random() % unsigned(block.rows + 1));
    const int column = int(random() % unsigned(block.columns + 1));
    move_corner(block, row, column, {9, -7});
    if (!find(blocks, 0.1)) {
      ++unclear;
      continue;
    }
    const Mesh mesh = build_mesh(reconcile(blocks).parts);
    ASSERT_EQ(validate(mesh), std::vector<std::string>{});
    const int i = std::min(row, block.rows - 1), j = std::min(column, block.columns - 1);
    const int corner = row > i ? (column > j ? 2 : 3) : (column > j ? 1 : 0);
    const Halfedge h{4 * (i * block.columns + j) + corner};
    if (mesh[mesh.origin(h)].is_junction()) continue;
    ++moved;
    EXPECT_LE(glm::distance(mesh.position(mesh.origin(h)),
                            block.patches[std::size_t(h.value / 4)].corner(corner).position),
              1e-4);
  }
  EXPECT_GT(moved, 50);
  EXPECT_LT(unclear, 10);
}

/// Moves a block as a whole, as a selector does.
void transform_block(PatchGrid& block, const Affine& linear) {
  const glm::dvec2 corner = block.patches.front().corner(0).position;
  const Affine map = Affine::translation(corner) * linear * Affine::translation(-corner);
  for (Patch& patch : block.patches) transform(patch, map);
}

TEST(CutBlocks, a_block_that_was_scaled_or_turned_as_well_is_where_it_was_put) {
  const Affine maps[] = {Affine::scaling({1.3, 1.3}), Affine::scaling({0.6, 1.1}),
                         Affine{glm::dmat2(0.8, 0.6, -0.6, 0.8), {30, 20}},
                         Affine{glm::dmat2(1, 0.1, 0.4, 0.9), {0, 0}}, Affine::scaling({-1, 1})};
  int inside = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    EditedBlocks blocks = random_blocks(seed);
    cut_at_random(blocks, random);
    for (PatchGrid& block : blocks.read)
      if (&block == &blocks.read[0] || random() % 4 == 0) transform_block(block, maps[seed % 5]);
    round_as_written(blocks.read, random);
    ASSERT_TRUE(find(blocks, 1e-3));
    const Reconciled result = reconcile(blocks);
    EXPECT_TRUE(result.edited);
    const Mesh mesh = build_mesh(result.parts);
    ASSERT_EQ(validate(mesh), std::vector<std::string>{});
    EXPECT_EQ(std::size_t(mesh.face_count()), parts_of(blocks.read).patches.size());
    // No other block has the points inside.
    const PatchGrid& block = blocks.read[0];
    for (int i = 1; i < block.rows; ++i)
      for (int j = 1; j < block.columns; ++j) {
        const int f = i * block.columns + j;
        const glm::dvec2 put = block.patches[std::size_t(f)].corner(0).position;
        EXPECT_LE(glm::distance(mesh.patch(Face{f}).corner(0).position, put), 1e-4);
        ++inside;
      }
  }
  EXPECT_GT(inside, 200);
}

/// Blocks that close around holes, or meet around a point of the boundary.
TEST(CutBlocks, closed_and_branched_arrangements_of_blocks_are_cut_too) {
  const MeshParts shapes[] = {test::ring(4), test::ring(6), test::dumbbell(), test::cross(2),
                              test::u_branch()};
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    MeshParts shape = shapes[seed % std::size(shapes)];
    transform(shape, Affine::scaling({30, 30}));
    EditedBlocks blocks = test::written_blocks(test::written_parts(shape, seed, int(seed % 20)));
    EXPECT_FALSE(reconcile(blocks).edited);
    cut_at_random(blocks, random);
    round_as_written(blocks.read, random);
    ASSERT_TRUE(find(blocks, 1e-4));
    const Mesh mesh = build_mesh(reconcile(blocks).parts);
    ASSERT_EQ(validate(mesh), std::vector<std::string>{});
    const std::vector<Patch> read = parts_of(blocks.read).patches;
    ASSERT_EQ(std::size_t(mesh.face_count()), read.size());
    for (const Face f : mesh.faces())
      EXPECT_LE(difference(mesh.patch(f), read[std::size_t(f.value)]), 0.06);
  }
}

PatchGrid stripes(const std::vector<double>& lines) {
  PatchGrid block{int(lines.size()) - 1, 1, {}};
  const auto value = [](double x, double y) { return Value{{x, y}, {0.5, 0.5, 0.5, 1}}; };
  for (std::size_t i = 1; i < lines.size(); ++i)
    block.patches.push_back(test::straight_patch({value(0, lines[i - 1]), value(100, lines[i - 1]),
                                                  value(100, lines[i]), value(0, lines[i])}));
  return block;
}

TEST(CutBlocks, lines_of_before_are_those_that_are_nearest) {
  const PatchGrid before = stripes({0, 100, 200});
  const auto rows = [&](const std::vector<double>& lines) {
    const auto cuts = find_cuts(before, stripes(lines));
    return cuts ? std::vector<std::size_t>{cuts->rows[0].size(), cuts->rows[1].size()}
                : std::vector<std::size_t>{};
  };
  using Counts = std::vector<std::size_t>;
  EXPECT_EQ(rows({0, 30, 100, 200}), (Counts{1, 0}));
  EXPECT_EQ(rows({0, 90, 120, 200}), (Counts{0, 1}));
  EXPECT_EQ(rows({0, 10, 20, 100, 150, 200}), (Counts{2, 1}));
  EXPECT_EQ(rows({0, 89, 110, 200}), Counts{}) << "either may be the new one";
}

TEST(CutBlocks, removed_blocks_are_holes) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const EditedBlocks blocks = random_blocks(seed);
    const Mesh mesh = build_mesh(reconcile(blocks).parts);
    const std::size_t gone = seed % blocks.read.size();
    if (blocks.read.size() == 1) continue;
    EditedBlocks edited = blocks;
    edited.removed[gone] = true;
    std::vector<Face> faces;
    for (const int patch : removed_patches(edited)) faces.push_back(Face{patch});
    EXPECT_EQ(faces.size(), blocks.read[gone].patches.size());
    const Mesh left = without_faces(mesh, faces);
    ASSERT_EQ(validate(left), std::vector<std::string>{});
    ASSERT_GE(left.face_count(), mesh.face_count() - int(faces.size()));
    // Every patch of before that stays is there, whole or in parts beside one another.
    int next = 0;
    for (const Face f : mesh.faces()) {
      if (std::ranges::find(faces, f) != faces.end()) continue;
      const Patch whole = mesh.patch(f);
      const auto area = [](const Patch& patch) {
        double sum = 0;
        for (int k = 0; k < 400; ++k) {
          const double u = (k / 20 + 0.5) / 20, v = (k % 20 + 0.5) / 20;
          const glm::dvec2 a = patch.derivative_u(u, v).position;
          const glm::dvec2 b = patch.derivative_v(u, v).position;
          sum += (a.x * b.y - a.y * b.x) / 400;
        }
        return sum;
      };
      double parts = area(left.patch(Face{next++}));
      while (std::abs(parts - area(whole)) > 0.002 * std::abs(area(whole)) &&
             next < left.face_count())
        parts += area(left.patch(Face{next++}));
    }
    EXPECT_EQ(next, left.face_count());
  }
}

}  // namespace
}  // namespace gradmesh
