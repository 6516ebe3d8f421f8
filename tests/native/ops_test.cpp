#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "mesh/dependence.h"
#include "mesh/validate.h"
#include "meshes.h"
#include "ops/merge.h"
#include "ops/split.h"

namespace gradmesh {
namespace {

using test::between;
using test::difference;
using test::grid_mesh;
using test::patches;

::testing::AssertionResult sound(const Mesh& mesh) {
  const std::vector<std::string> broken = validate(mesh);
  if (broken.empty()) return ::testing::AssertionSuccess();
  auto result = ::testing::AssertionFailure();
  for (const std::string& b : broken) result << b << "; ";
  return result;
}

/// Along each curve the patches of both sides must lie on the very same points.
void expect_no_gap(const Mesh& mesh) {
  for (const Halfedge h : mesh.halfedges()) {
    if (mesh.is_bar(h) || !mesh[h].twin.valid()) continue;
    const Cubic<Value> curve = mesh.curve_of(h);
    for (const Halfedge side : {h, mesh[h].twin})
      for (const Halfedge leaf : mesh.leaves(side)) {
        const Patch patch = mesh.patch(mesh.face(leaf));
        const auto around = mesh.sides(mesh.face(leaf));
        const int k = int(std::ranges::find(around, leaf) - around.begin());
        const Interval span = mesh.span(leaf);
        for (const double t : {0.0, 0.3, 0.5, 0.9, 1.0}) {
          double at = span.first + t * span.length();
          if (side != h) at = 1 - at;
          const glm::dvec2 gap = patch.side(k).at(t).position - curve.at(at).position;
          EXPECT_LE(glm::length(gap), 1e-9 * (1 + glm::length(curve.at(at).position)));
        }
      }
  }
}

TEST(Mesh, grid_is_sound) {
  const Mesh mesh = grid_mesh({.rows = 3, .columns = 4, .position_noise = 0.1});
  EXPECT_TRUE(sound(mesh));
  EXPECT_EQ(mesh.face_count(), 12);
  EXPECT_EQ(std::ranges::distance(mesh.points()), 20);
  EXPECT_EQ(std::ranges::distance(mesh.halfedges()), 48);
}

TEST(Split, then_merge_gives_back_the_patch) {
  std::mt19937 random(7);
  for (const ColorModel model : {ColorModel::bilinear, ColorModel::bicubic})
    for (int round = 0; round < 200; ++round) {
      Mesh mesh = grid_mesh({.rows = 3,
                             .columns = 3,
                             .position_noise = 0.15,
                             .color_noise = 0.2,
                             .color_model = model},
                            round);
      const std::vector<Patch> before = patches(mesh);
      Journal journal(mesh);
      const Face f{std::uniform_int_distribution<int>(0, 8)(random)};
      const Halfedge side = mesh.sides(f)[std::uniform_int_distribution<int>(0, 3)(random)];
      const double t = std::uniform_real_distribution<double>(0.05, 0.95)(random);
      const Halfedge edge = split(journal, side, t);
      ASSERT_TRUE(sound(mesh));
      expect_no_gap(mesh);
      EXPECT_EQ(mesh.face_count(), 10);
      ASSERT_EQ(can_merge(mesh, edge), MergeObstacle::none);
      merge(journal, edge);
      ASSERT_TRUE(sound(mesh));
      const std::vector<Patch> after = patches(mesh);
      ASSERT_EQ(after.size(), before.size());
      for (std::size_t i = 0; i < after.size(); ++i)
        EXPECT_LE(difference(before[i], after[i]), 1e-9);
    }
}

TEST(Split, parts_are_the_patch) {
  Mesh mesh = grid_mesh({.position_noise = 0.2, .color_noise = 0.3}, 3);
  const Patch whole = mesh.patch(Face{4});
  Journal journal(mesh);
  split(journal, mesh.sides(Face{4})[0], 0.3);
  const Patch left = mesh.patch(Face{4}), right = mesh.patch(Face{9});
  for (const double u : {0.0, 0.4, 1.0})
    for (const double v : {0.0, 0.2, 0.7, 1.0}) {
      const Value a = left.at(u, v) - whole.at(u, 0.3 * v);
      const Value b = right.at(u, v) - whole.at(u, 0.3 + 0.7 * v);
      EXPECT_LE(glm::length(a.position) + glm::length(a.color), 1e-9);
      EXPECT_LE(glm::length(b.position) + glm::length(b.color), 1e-9);
    }
}

TEST(Merge, random_sequences_keep_every_invariant) {
  int merges = 0, splits = 0, undone = 0, nested = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    const auto pick = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
    Mesh mesh = grid_mesh(
        {.rows = 1 + pick(5), .columns = 1 + pick(5), .position_noise = 0.1, .color_noise = 0.2},
        seed);
    Journal journal(mesh);
    std::vector<std::vector<Patch>> history{patches(mesh)};
    for (int step = 0; step < 40; ++step) {
      std::vector<Halfedge> edges, leaves;
      for (const Halfedge h : mesh.halfedges()) {
        if (mesh.is_leaf(h)) leaves.push_back(h);
        if (can_merge(mesh, h) == MergeObstacle::none) edges.push_back(h);
      }
      const int action = pick(10);
      if (action < 2 && history.size() > 1) {
        journal.undo();
        history.pop_back();
        ++undone;
        ASSERT_EQ(patches(mesh), history.back()) << "seed " << seed << " step " << step;
      } else if (action < 4 || edges.empty()) {
        split(journal, leaves[pick(int(leaves.size()))],
              std::uniform_real_distribution<double>(0.2, 0.8)(random));
        history.push_back(patches(mesh));
        ++splits;
      } else {
        const Halfedge edge = edges[pick(int(edges.size()))];
        const int faces = mesh.face_count();
        merge(journal, edge);
        ASSERT_EQ(mesh.face_count(), faces - 1);
        history.push_back(patches(mesh));
        ++merges;
      }
      ASSERT_TRUE(sound(mesh)) << "seed " << seed << " step " << step;
      expect_no_gap(mesh);
      for (const Halfedge h : mesh.halfedges())
        if (mesh.is_stem(h) && mesh.is_parent(h)) ++nested;
    }
    while (journal.depth() > 0) journal.undo();
    ASSERT_EQ(patches(mesh), history.front());
  }
  // The sequences reach what they are meant to.
  EXPECT_GT(merges, 2000);
  EXPECT_GT(splits, 500);
  EXPECT_GT(undone, 500);
  EXPECT_GT(nested, 100);
}

}  // namespace
}  // namespace gradmesh
