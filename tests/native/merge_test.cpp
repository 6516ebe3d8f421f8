#include <gtest/gtest.h>

#include <functional>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "mesh/dependence.h"
#include "mesh/validate.h"
#include "meshes.h"
#include "ops/merge.h"
#include "ops/merge_end.h"
#include "ops/split.h"

namespace gradmesh {
namespace {

using test::between;
using test::difference;
using test::grid_mesh;

Face at(int row, int column, int columns) { return Face{row * columns + column}; }

/// The T-junctions of the paper's Fig. 4 in a grid of 3 x 3.
class Grid : public ::testing::Test {
 protected:
  Mesh mesh = grid_mesh({.position_noise = 0.05, .color_noise = 0.2}, 11);
  Journal journal{mesh};

  Halfedge edge(int a, int b) { return between(mesh, Face{a}, Face{b}); }
  void merge_faces(int a, int b) {
    const Halfedge e = edge(a, b);
    ASSERT_TRUE(e.valid());
    ASSERT_EQ(can_merge(mesh, e), MergeObstacle::none) << describe(can_merge(mesh, e));
    merge(journal, e);
    ASSERT_EQ(validate(mesh), std::vector<std::string>{});
  }
  std::vector<Halfedge> parents() const {
    std::vector<Halfedge> result;
    for (const Halfedge h : mesh.halfedges())
      if (mesh.is_parent(h)) result.push_back(h);
    return result;
  }
};

TEST_F(Grid, a_merge_at_the_boundary_removes_a_point_and_inserts_a_junction) {
  const double r = split_factor(mesh, edge(0, 1));
  merge_faces(0, 1);
  ASSERT_EQ(parents().size(), 1u);
  const std::vector<Halfedge> children = mesh.children(parents()[0]);
  ASSERT_EQ(children.size(), 3u);
  EXPECT_TRUE(mesh.is_bar(children[0]) && mesh.is_stem(children[1]) && mesh.is_bar(children[2]));
  // The parent runs along the tops of faces 3 and 4, in their direction: from left to right.
  EXPECT_EQ(mesh.face(children[0]), Face{3});
  EXPECT_EQ(mesh.face(children[2]), Face{4});
  EXPECT_NEAR(mesh[children[1]].interval.first, r, 1e-12);
  EXPECT_EQ(std::ranges::distance(mesh.points()), 15);
}

TEST_F(Grid, a_junction_is_removed_when_its_stem_is_merged) {
  merge_faces(0, 1);
  const Cubic<Value> parent = mesh.curve_of(parents()[0]);
  merge_faces(3, 4);
  // The bars are gone, the curve between is a plain one, and as it was.
  EXPECT_EQ(parents().size(), 1u);
  const Halfedge plain = edge(0, 3);
  ASSERT_TRUE(plain.valid());
  EXPECT_EQ(mesh.curve_of(mesh[plain].twin).p0.position, parent.p0.position);
  EXPECT_EQ(mesh.curve_of(mesh[plain].twin).m0.position, parent.m0.position);
}

TEST_F(Grid, two_of_three_bars_become_one) {
  merge_faces(0, 1);
  merge_faces(0, 2);
  ASSERT_EQ(mesh.leaves(parents()[0]).size(), 3u);
  const Interval first = mesh[mesh.leaves(parents()[0])[0]].interval;
  const Interval second = mesh[mesh.leaves(parents()[0])[1]].interval;
  merge_faces(3, 4);
  Halfedge parent;
  for (const Halfedge p : parents())
    if (mesh.face(mesh.leaves(p)[0]) == Face{3} && mesh.leaves(p).size() == 2) parent = p;
  ASSERT_TRUE(parent.valid());
  EXPECT_EQ(mesh[mesh.leaves(parent)[0]].interval, (Interval{first.first, second.second}));
}

TEST_F(Grid, parents_of_unrelated_junctions_are_combined) {
  // Faces 0|1 merged from above and 7|8 from below leave bars on both sides of the middle row's
  // corners; merging 4|5 joins a bar with a plain curve (Fig. 4c).
  merge_faces(0, 1);
  const Halfedge e = edge(4, 5);
  const double r = split_factor(mesh, e);
  const Halfedge top_bar = mesh.prev(e);
  ASSERT_TRUE(mesh.is_bar(top_bar));
  const double s = mesh.span(top_bar).length();
  const double length_left = mesh.curve_of(mesh[top_bar].parent).m0.position.x;
  merge_faces(4, 5);

  // Eq. 6 with q = 1, since face 5's top was a whole curve.
  const double expected = 1 / (1 + (1 - r) / r * s);
  Halfedge parent;
  for (const Halfedge p : parents())
    for (const Halfedge leaf : mesh.leaves(p))
      if (mesh.face(leaf) == Face{4} && mesh.leaves(p).size() == 2 &&
          mesh.face(mesh.leaves(p)[0]) == Face{3})
        parent = p;
  ASSERT_TRUE(parent.valid());
  // On the far side stand face 0 (both columns) and face 2, with the junction at 1 - t'.
  const Halfedge twin = mesh[parent].twin;
  ASSERT_EQ(mesh.leaves(twin).size(), 2u);
  EXPECT_EQ(mesh.face(mesh.leaves(twin)[0]), Face{2});
  EXPECT_NEAR(mesh[mesh.leaves(twin)[0]].interval.second, 1 - expected, 1e-12);
  // Near side: face 3's bar, then the merged face's.
  EXPECT_NEAR(mesh[mesh.leaves(parent)[0]].interval.second, expected * (1 - s), 1e-12);
  EXPECT_NEAR(mesh.curve_of(parent).m0.position.x, length_left / expected, 1e-9);
}

TEST_F(Grid, the_five_conditions) {
  for (const Halfedge h : mesh.halfedges())
    if (!mesh[h].twin.valid()) {
      EXPECT_EQ(can_merge(mesh, h), MergeObstacle::boundary);
    }
  merge_faces(0, 1);
  const Halfedge parent = parents()[0];
  EXPECT_EQ(can_merge(mesh, parent), MergeObstacle::parent);
  EXPECT_EQ(can_merge(mesh, mesh[parent].twin), MergeObstacle::parent);
  for (const Halfedge bar : mesh.leaves(parent))
    EXPECT_EQ(can_merge(mesh, bar), MergeObstacle::bar);
}

/// Merges round the middle face like the vanes of a pinwheel: the fourth would close a cycle
/// (Fig. 5). Going round the middle face clockwise, each parent ends on its next or, the other way
/// round, starts on the one before, as its stem.
TEST_F(Grid, a_pinwheel_is_refused_clockwise) {
  merge_faces(0, 1);
  merge_faces(2, 5);
  merge_faces(8, 7);
  EXPECT_EQ(can_merge(mesh, edge(6, 3)), MergeObstacle::next_cycle);
}
TEST_F(Grid, a_pinwheel_is_refused_counterclockwise) {
  merge_faces(1, 2);
  merge_faces(5, 8);
  merge_faces(7, 6);
  EXPECT_EQ(can_merge(mesh, edge(3, 0)), MergeObstacle::origin_cycle);
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
  for (const Halfedge h : mesh.halfedges()) {
    if (mesh.is_bar(h) || mesh.curve(h) != h || h == mesh.curve(edge)) continue;
    for (const Halfedge s : supports(mesh, h)) hangs.insert({node(h), node(s)});
  }
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
    EXPECT_NEAR(split_factor(mesh, edge), t, 1e-10);
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
    const double r = split_factor(mesh, Halfedge{1});
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
  EXPECT_EQ(split_factor(mesh, Halfedge{1}), 0.5);
}

TEST(Branch, a_point_with_three_faces_on_the_boundary_stays) {
  // An L of three patches: 0 | 1 beside each other, 2 below 1 (Fig. 6).
  const auto unit = [](double x, double y) {
    const auto corner = [&](double a, double b) {
      return Value{{x + a, y + b}, {0.5, 0.5, 0.5, 1}};
    };
    return test::straight_patch({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
  };
  const Mesh l = build_mesh({{unit(0, 0), unit(1, 0), unit(1, 1)},
                             {{{{1}, {}}, {{7}, {}}}, {{{6}, {}}, {{8}, {}}}},
                             ColorModel::bilinear});
  EXPECT_EQ(validate(l), std::vector<std::string>{});
  EXPECT_EQ(can_merge(l, Halfedge{1}), MergeObstacle::branch);
  EXPECT_EQ(can_merge(l, Halfedge{6}), MergeObstacle::branch);
  // A U: a fourth patch left of 2, below 0 but not joined with it.
  const Mesh u =
      build_mesh({{unit(0, 0), unit(1, 0), unit(1, 1), unit(0, 1)},
                  {{{{1}, {}}, {{7}, {}}}, {{{6}, {}}, {{8}, {}}}, {{{11}, {}}, {{13}, {}}}},
                  ColorModel::bilinear});
  for (const int h : {1, 6, 11}) EXPECT_EQ(can_merge(u, Halfedge{h}), MergeObstacle::branch);
}

/// A ring of n patches, each joined to the next by its right side.
Mesh ring(int n) {
  MeshParts parts;
  for (int i = 0; i < n; ++i) {
    const auto corner = [&](int k, double radius) {
      const double a = 2 * 3.14159265358979 * k / n;
      return Value{{radius * std::cos(a), radius * std::sin(a)}, {0.1, 0.2, 0.3, 1}};
    };
    parts.patches.push_back(test::straight_patch(
        {corner(i, 2), corner((i + 1) % n, 2), corner((i + 1) % n, 1), corner(i, 1)}));
    parts.curves.push_back({{{4 * i + 1}, {}}, {{4 * ((i + 1) % n) + 3}, {}}});
  }
  return build_mesh(parts);
}

TEST(Ring, can_be_merged_down_to_one_patch_but_not_into_itself) {
  Mesh mesh = ring(5);
  Journal journal(mesh);
  for (int merges = 0; merges < 4; ++merges) {
    Halfedge edge;
    for (const Halfedge h : mesh.halfedges())
      if (can_merge(mesh, h) == MergeObstacle::none) edge = h;
    ASSERT_TRUE(edge.valid());
    merge(journal, edge);
    ASSERT_EQ(validate(mesh), std::vector<std::string>{});
  }
  for (const Halfedge h : mesh.halfedges()) EXPECT_NE(can_merge(mesh, h), MergeObstacle::none);
  while (journal.depth()) journal.undo();
  EXPECT_EQ(mesh.patch(Face{3}), ring(5).patch(Face{3}));
}

TEST(Merge, undo_touches_what_the_merge_touched_alone) {
  Mesh mesh = grid_mesh({.rows = 8, .columns = 8, .position_noise = 0.05}, 4);
  std::vector<Patch> before;
  for (const Face f : mesh.faces()) before.push_back(mesh.patch(f));
  Journal journal(mesh);
  merge(journal, between(mesh, at(3, 3, 8), at(3, 4, 8)));
  // The two, and those above and below both.
  const std::vector<Face> list = journal.touched_since(0);
  EXPECT_EQ(list.size(), 6u);
  const std::set<Face> touched(list.begin(), list.end());
  for (const Face f : mesh.faces())
    if (!touched.contains(f)) {
      EXPECT_EQ(mesh.patch(f), before[f.value]);
    }
  journal.undo();
  for (const Face f : mesh.faces()) EXPECT_EQ(mesh.patch(f), before[f.value]);
}

TEST(Build, refuses_what_does_not_fit_together) {
  std::mt19937 random(1);
  const MeshParts good = test::grid_parts({.rows = 2, .columns = 2}, random);
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
