#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "mesh/dependence.h"
#include "mesh/validate.h"
#include "meshes.h"
#include "ops/merge/merge.h"
#include "ops/refresh.h"
#include "ops/split/split.h"
#include "random_meshes.h"

namespace gradmesh {
namespace {

using test::between;
using test::difference;
using test::grid_mesh;
using test::patches;
using test::sound;

void expect_near(const std::vector<Patch>& a, const std::vector<Patch>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LE(difference(a[i], b[i]), 1e-9);
}

/// Along each curve the patches of both sides must lie on the very same points.
void expect_no_gap(const Mesh& mesh) {
  for (const Halfedge h : mesh.curves()) {
    if (!mesh[h].twin.valid()) continue;
    const Cubic<Value> curve = mesh.curve_of(h);
    for (const Halfedge side : {h, mesh[h].twin})
      for (const Halfedge leaf : mesh.leaves(side)) {
        const Cubic<Value> of_patch = mesh.patch(mesh.face(leaf)).side(mesh.side_number(leaf));
        const Interval span = mesh.span(leaf);
        for (const double t : {0.0, 0.3, 0.5, 0.9, 1.0}) {
          double at = span.first + t * span.length();
          if (side != h) at = 1 - at;
          const glm::dvec2 gap = of_patch.at(t).position - curve.at(at).position;
          EXPECT_LE(glm::length(gap), 1e-9 * (1 + glm::length(curve.at(at).position)));
        }
      }
  }
}

TEST(Mesh, grid_is_sound) {
  const Mesh mesh = grid_mesh({.rows = 3, .columns = 4, .position_noise = 0.1});
  EXPECT_EQ(validate(mesh), sound);
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
      ASSERT_EQ(validate(mesh), sound);
      expect_no_gap(mesh);
      EXPECT_EQ(mesh.face_count(), 10);
      ASSERT_EQ(can_merge(mesh, edge), MergeObstacle::none);
      merge(journal, edge);
      ASSERT_EQ(validate(mesh), sound);
      expect_near(patches(mesh), before);
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

/// Gives half of the half-edges at T-junctions colours of their own.
void recolor_junctions(Journal& journal, std::mt19937& random) {
  const Mesh& mesh = journal.mesh();
  std::uniform_real_distribution<double> channel(0, 1);
  for (const Halfedge h : mesh.halfedges()) {
    if (!mesh.is_leaf(h) || !mesh[mesh.origin(h)].is_junction() || random() % 2) continue;
    journal.begin();
    journal.edit(h).own_color = true;
    for (int i = 0; i < 4; ++i) journal.edit(h).color[i] = channel(random);
    refresh(journal, std::array{mesh.curve(h), mesh.curve(mesh.prev(h))});
  }
}

double color_difference(Patch a, Patch b) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) a.c[i][j].position = b.c[i][j].position;
  return difference(a, b);
}

/// Splits a patch at random; all patches are what they were, and the new ones its parts.
void expect_exact_split(Journal& journal, std::mt19937& random) {
  const Mesh& mesh = journal.mesh();
  const std::vector<Face> faces(mesh.faces().begin(), mesh.faces().end());
  std::vector<Patch> expected = patches(mesh);
  const Face f = faces[random() % faces.size()];
  const int k = int(random() % 4);
  const double t = std::uniform_real_distribution<double>(0.1, 0.9)(random);
  const Patch whole = mesh.patch(f);
  const bool across = k % 2 == 0;
  std::array<Patch, 2> parts =
      across ? whole.split_v(k == 0 ? t : 1 - t) : whole.split_u(k == 1 ? t : 1 - t);
  if (k > 1) std::swap(parts[0], parts[1]);
  const Halfedge edge = split(journal, mesh.sides(f)[std::size_t(k)], t);
  ASSERT_EQ(validate(mesh), sound);
  const auto expect_same = [&](Face face, const Patch& wanted) {
    EXPECT_LE(color_difference(mesh.patch(face), wanted), 1e-12);
    EXPECT_LE(difference(mesh.patch(face), wanted), 1e-9);
  };
  for (std::size_t i = 0; i < faces.size(); ++i)
    expect_same(faces[i], faces[i] == f ? parts[0] : expected[i]);
  expect_same(mesh.face(mesh[edge].twin), parts[1]);
}

TEST(Split, is_exact_beside_recoloured_junctions) {
  for (const ColorModel model : {ColorModel::bilinear, ColorModel::bicubic})
    for (unsigned seed = 0; seed < 60; ++seed) {
      std::mt19937 random(seed);
      const MeshParts parts = test::grid_parts({.rows = 4,
                                                .columns = 4,
                                                .position_noise = 0.1,
                                                .color_noise = 0.2,
                                                .color_model = model},
                                               random);
      Mesh mesh = test::changed_mesh(parts, seed, 12, 5);
      Journal journal(mesh);
      recolor_junctions(journal, random);
      for (int i = 0; i < 12; ++i) expect_exact_split(journal, random);
      ASSERT_FALSE(testing::Test::HasFailure())
          << "color model " << int(model) << ", seed " << seed;
    }
}

TEST(Split, then_merge_gives_back_a_patch_between_recoloured_junctions) {
  Mesh mesh = test::grid_mesh(
      {.rows = 2, .columns = 1, .color_noise = 0.2, .color_model = ColorModel::bicubic});
  Journal journal(mesh);
  const Halfedge right = mesh[split(journal, mesh.sides(Face{1})[0], 0.3)].twin;
  split(journal, mesh.sides(mesh.face(right))[0], 0.5);
  std::mt19937 random(3);
  recolor_junctions(journal, random);
  const std::vector<Patch> before = patches(mesh);
  merge(journal, split(journal, mesh.sides(mesh.face(right))[0], 0.4));
  expect_near(patches(mesh), before);
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
      const auto edges = test::mergeable_edges(mesh), leaves = test::all_leaves(mesh);
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
      ASSERT_EQ(validate(mesh), sound) << "seed " << seed << " step " << step;
      expect_no_gap(mesh);
      for (const Halfedge h : mesh.halfedges())
        if (mesh.is_stem(h) && mesh.is_parent(h)) ++nested;
    }
    journal.undo_to(0);
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
