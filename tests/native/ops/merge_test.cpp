#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "mesh/dependence.h"
#include "mesh/validate.h"
#include "ops/merge/merge_end.h"
#include "random_meshes.h"

namespace gradmesh {
namespace {

using test::between;
using test::grid_mesh;

TEST(CanMerge, names_the_condition_that_fails) {
  Mesh mesh = grid_mesh({.position_noise = 0.05, .color_noise = 0.2}, 11);
  Journal journal(mesh);
  for (const Halfedge h : mesh.halfedges())
    if (!mesh[h].twin.valid()) {
      EXPECT_EQ(can_merge(mesh, h), MergeObstacle::boundary);
    }
  merge(journal, between(mesh, Face{0}, Face{1}));
  const auto all = mesh.halfedges();
  const Halfedge parent =
      *std::find_if(all.begin(), all.end(), [&](Halfedge h) { return mesh.is_parent(h); });
  EXPECT_EQ(can_merge(mesh, parent), MergeObstacle::parent);
  EXPECT_EQ(can_merge(mesh, mesh[parent].twin), MergeObstacle::parent);
  for (const Halfedge bar : mesh.leaves(parent))
    EXPECT_EQ(can_merge(mesh, bar), MergeObstacle::bar);
}

/// Written down once more, naively: curves as nodes, contracted and hung as the merge would.
bool would_cycle(const Mesh& mesh, Halfedge edge) {
  std::map<Halfedge, Halfedge> same;
  std::set<std::pair<Halfedge, Halfedge>> hangs;
  const auto node = [&](Halfedge h) {
    Halfedge c = mesh.curve(h);
    while (same.contains(c)) c = same[c];
    return c;
  };
  std::vector<MergeEnd> ends{merge_end(mesh, edge), merge_end(mesh, mesh[edge].twin)};
  for (const MergeEnd& end : ends)
    if (end.kind == MergeEnd::interior && node(end.in) != node(end.out))
      same[node(end.out)] = node(end.in);
  for (const Halfedge h : mesh.curves())
    if (h != mesh.curve(edge))
      for (const Halfedge s : supports(mesh, h)) hangs.insert({node(h), node(s)});
  for (const MergeEnd& end : ends)
    if (end.kind == MergeEnd::interior) hangs.insert({node(end.across), node(end.in)});
  // Take away what hangs on nothing until nothing is left, or a cycle.
  while (true) {
    std::set<Halfedge> hanging;
    for (const auto& [a, b] : hangs) hanging.insert(a);
    const std::size_t before = hangs.size();
    std::erase_if(hangs, [&](const auto& pair) { return !hanging.contains(pair.second); });
    if (hangs.empty()) return false;
    if (hangs.size() == before) return true;
  }
}

TEST(Cycles, are_refused_exactly_where_they_would_arise) {
  int refused = 0, allowed = 0;
  for (unsigned seed = 0; seed < 150; ++seed) {
    std::mt19937 random(seed);
    Mesh mesh = grid_mesh({.rows = 5, .columns = 5, .position_noise = 0.05}, seed);
    Journal journal(mesh);
    while (true) {
      std::vector<Halfedge> edges;
      for (const Halfedge h : mesh.halfedges()) {
        const MergeObstacle obstacle = can_merge(mesh, h);
        const bool cycle =
            obstacle == MergeObstacle::next_cycle || obstacle == MergeObstacle::origin_cycle;
        if (obstacle == MergeObstacle::none || cycle) {
          ASSERT_EQ(cycle, would_cycle(mesh, h)) << "seed " << seed << " halfedge " << h.value;
          ++(cycle ? refused : allowed);
        }
        if (obstacle == MergeObstacle::none) edges.push_back(h);
      }
      if (edges.empty()) break;
      merge(journal, edges[random() % edges.size()]);
    }
  }
  EXPECT_GT(refused, 300);
  EXPECT_GT(allowed, 10000);
}

TEST(SplitFactor, is_exact_for_exact_splits) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    Mesh mesh = grid_mesh({.rows = 1, .columns = 1, .position_noise = 0.2}, seed);
    Journal journal(mesh);
    const double t = 0.1 + 0.008 * seed;
    const Halfedge edge = split(journal, mesh.sides(Face{0})[seed % 4], t);
    EXPECT_NEAR(test::split_factor(mesh, edge), t, 1e-10);
  }
}

TEST(SplitFactor, comes_from_the_lengths_where_tangents_vanish_or_point_apart) {
  // Two patches 30 and 70 wide, whose tangents across the edge are as the case says.
  for (const double tangent : {0.0, 1.0, -1.0}) {
    const auto wide = [&](double x0, double x1, bool left) {
      const auto corner = [](double x, double y) { return Value{{x, y}, {0, 0, 0, 1}}; };
      Patch p =
          test::straight_patch({corner(x0, 0), corner(x1, 0), corner(x1, 50), corner(x0, 50)});
      for (const int i : {0, 3}) {
        const glm::dvec2 away = left ? p.c[i][1].position : p.c[i][2].position;
        p.c[i][left ? 2 : 1].position = tangent > 0 && !left ? glm::dvec2(0, 1) * 20.0
                                        : tangent > 0        ? glm::dvec2(0, -1) * 20.0
                                                             : away * tangent * (left ? 1.0 : -1.0);
      }
      return p;
    };
    MeshParts parts{
        {wide(0, 30, true), wide(30, 100, false)}, grid_curves(1, 2), ColorModel::bilinear};
    const Mesh mesh = build_mesh(parts);
    const double r = test::split_factor(mesh, Halfedge{1});
    EXPECT_TRUE(std::isfinite(r));
    EXPECT_GT(r, 0);
    EXPECT_LT(r, 1);
    if (tangent == 0) {
      EXPECT_NEAR(r, 0.3, 0.01);
    }
  }
}

TEST(SplitFactor, holds_for_patches_without_any_size) {
  const Patch point = test::straight_patch({Value{}, Value{}, Value{}, Value{}});
  const Mesh mesh = build_mesh({{point, point}, grid_curves(1, 2), ColorModel::bilinear});
  EXPECT_EQ(test::split_factor(mesh, Halfedge{1}), 0.5);
}

TEST(Merge, undo_touches_what_the_merge_touched_alone) {
  Mesh mesh = grid_mesh({.rows = 8, .columns = 8, .position_noise = 0.05}, 4);
  const std::vector<Patch> before = test::patches(mesh);
  Journal journal(mesh);
  merge(journal, between(mesh, Face{3 * 8 + 3}, Face{3 * 8 + 4}));
  // The two, and those above and below both.
  const std::vector<Face> list = journal.touched_since(0);
  EXPECT_EQ(list.size(), 6u);
  const std::set<Face> touched(list.begin(), list.end());
  for (const Face f : mesh.faces())
    if (!touched.contains(f)) {
      EXPECT_EQ(mesh.patch(f), before[f.value]);
    }
  journal.undo();
  EXPECT_EQ(test::patches(mesh), before);
}

TEST(Build, refuses_what_does_not_fit_together) {
  const MeshParts good = test::grid_parts({.rows = 2, .columns = 2});
  const auto expect_refused = [&](const std::function<void(MeshParts&)>& spoil) {
    MeshParts parts = good;
    spoil(parts);
    EXPECT_THROW(build_mesh(parts), std::runtime_error);
  };
  expect_refused([](MeshParts& p) { p.curves[0].a.halfedges[0] = 99; });
  expect_refused([](MeshParts& p) { p.curves.push_back(p.curves[0]); });
  expect_refused([](MeshParts& p) { p.curves[0].b.halfedges.clear(); });
  expect_refused([](MeshParts& p) { p.curves[0].a.breaks.push_back(0.5); });
  // Two bars between which no curve stands.
  expect_refused([](MeshParts& p) { p.curves = {{{{0, 10}, {0.5}}, {{4}, {}}}}; });
}

}  // namespace
}  // namespace gradmesh
