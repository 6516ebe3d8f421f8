#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "base/progress.h"
#include "branch_meshes.h"
#include "mesh/subdivide.h"
#include "mesh/validate.h"
#include "meshes.h"
#include "methods/merging/gqe.h"
#include "methods/merging/grid.h"
#include "methods/merging/motorcycle.h"
#include "methods/merging/random.h"
#include "methods/merging/regions.h"
#include "ops/merge/merge_region.h"
#include "ops/split/split.h"
#include "problems.h"
#include "random_meshes.h"

namespace gradmesh {
namespace {

using test::grid_mesh;

MeshParts parts(int rows, int columns, unsigned seed, double noise = 0.03) {
  return test::grid_parts(
      {.rows = rows, .columns = columns, .position_noise = noise, .color_noise = noise}, seed);
}

/// What a selection works on.
struct Bench {
  explicit Bench(const Mesh& original, double epsilon = 0.01, MetricKind metric = MetricKind::flip)
      : mesh(original),
        trial(mesh, test::edit_error(original, mesh, fit_frame(mesh, {}, 120), metric), epsilon) {}

  Mesh mesh;
  MergeTrial trial;
  PriceTable analysis;
  StopWatch watch{0, {}};
};

using FacePairs = std::vector<std::pair<int, int>>;

/// Edges as the pairs of faces beside them.
FacePairs faces_of(const Mesh& mesh, const std::vector<Halfedge>& edges) {
  FacePairs pairs;
  for (const Halfedge h : edges) {
    const int a = mesh.face(h).value, b = mesh.face(mesh[h].twin).value;
    pairs.emplace_back(std::min(a, b), std::max(a, b));
  }
  return pairs;
}

/// `wanted` is the order from the top left corner on along the top row, which some seed gives.
void expect_orders(std::vector<Halfedge> (*order_of)(const Mesh&, std::uint64_t),
                   const FacePairs& wanted) {
  const Mesh mesh = grid_mesh();
  std::set<FacePairs> orders;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const FacePairs order = faces_of(mesh, order_of(mesh, seed));
    EXPECT_EQ(std::set(order.begin(), order.end()), std::set(wanted.begin(), wanted.end()));
    EXPECT_EQ(order.size(), wanted.size());
    orders.insert(order);
  }
  EXPECT_TRUE(orders.contains(wanted));
  // Four corners, two directions.
  EXPECT_EQ(orders.size(), 8u);
}

TEST(GridOrder, goes_through_rows_and_then_between_them) {  // Fig. 7a
  expect_orders(grid_order, {{0, 1},
                             {1, 2},
                             {3, 4},
                             {4, 5},
                             {6, 7},
                             {7, 8},
                             {0, 3},
                             {3, 6},
                             {1, 4},
                             {4, 7},
                             {2, 5},
                             {5, 8}});
}

TEST(DualGridOrder, goes_along_lines) {  // Fig. 7b
  expect_orders(dual_grid_order, {{0, 1},
                                  {3, 4},
                                  {6, 7},
                                  {1, 2},
                                  {4, 5},
                                  {7, 8},
                                  {0, 3},
                                  {1, 4},
                                  {2, 5},
                                  {3, 6},
                                  {4, 7},
                                  {5, 8}});
}

std::set<Halfedge> inner_curves(const Mesh& mesh) {
  std::set<Halfedge> curves;
  for (const Halfedge curve : mesh.curves())
    if (mesh[curve].twin.valid()) curves.insert(curve);
  return curves;
}

TEST(GridOrder, reaches_every_edge_of_meshes_with_junctions_and_several_components) {
  std::mt19937 random(1);
  MeshParts parts = test::grid_parts({.rows = 2, .columns = 3}, random);
  append(parts, test::grid_parts({.rows = 2, .columns = 2}, random));
  Mesh mesh = build_mesh(parts);
  Journal journal(mesh);
  split(journal, mesh.sides(Face{1})[0], 0.5);
  const std::vector<Halfedge> order = grid_order(mesh, 0);
  std::set<Halfedge> listed;
  for (const Halfedge h : order) listed.insert(mesh.curve(h));
  EXPECT_EQ(listed, inner_curves(mesh));
  EXPECT_EQ(order.size(), listed.size());
}

TEST(RandomOrder, holds_every_edge_once_and_follows_the_seed) {
  const Mesh mesh = test::changed_mesh(parts(3, 3, 1), 4, 3);
  const std::set<Halfedge> edges = inner_curves(mesh);
  std::set<std::vector<Halfedge>> orders;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const std::vector<Halfedge> order = random_order(mesh, seed);
    EXPECT_EQ(std::set(order.begin(), order.end()), edges);
    EXPECT_EQ(order.size(), edges.size());
    EXPECT_EQ(order, random_order(mesh, seed));
    orders.insert(order);
  }
  EXPECT_EQ(orders.size(), 10u);
}

/// How many rectangles of more than one cell a grid holds.
int rectangles(int rows, int columns) {
  return rows * (rows + 1) / 2 * columns * (columns + 1) / 2 - rows * columns;
}

TEST(Regions, of_a_grid_are_its_rectangles_each_priced_once) {
  for (const auto& [rows, columns] : {std::pair(1, 5), std::pair(3, 4), std::pair(4, 4)}) {
    Bench b(build_mesh(parts(rows, columns, 2)));
    const auto regions = price_regions(b.trial, b.analysis, 1, b.watch);
    EXPECT_EQ(int(regions.size()), rectangles(rows, columns));
    EXPECT_EQ(b.trial.evaluations(), rectangles(rows, columns));
    std::set<std::set<Face>> sets;
    for (const RegionPrice& r : regions) {
      const std::set<Face> faces(r.patches.begin(), r.patches.end());
      EXPECT_EQ(int(faces.size()), r.region.size());
      sets.insert(faces);
    }
    EXPECT_EQ(sets.size(), regions.size());
  }
}

TEST(Regions, cost_what_the_whole_frame_says) {
  for (const MetricKind metric : {MetricKind::flip, MetricKind::ssim}) {
    const Mesh original = test::changed_mesh(parts(4, 4, 3), 5, 4);
    Bench b(original, 0.01, metric);
    for (const RegionPrice& r : price_regions(b.trial, b.analysis, 1, b.watch)) {
      Mesh merged = original;
      Journal journal(merged);
      ASSERT_TRUE(merge_region(journal, r.region).valid());
      EXPECT_EQ(validate(merged), std::vector<std::string>{});
      EXPECT_EQ(merged.face_count(), original.face_count() - r.size() + 1);
      EXPECT_NEAR(r.error, b.trial.measure().whole_frame(merged).mean, 1e-9);
    }
    for (const Face f : original.faces()) EXPECT_EQ(b.mesh.patch(f), original.patch(f));
  }
}

TEST(Regions, grow_only_from_those_within_the_limit) {
  Bench b(build_mesh(parts(4, 5, 7, 0.1)));
  const auto all = price_regions(b.trial, b.analysis, 1, b.watch);
  const int priced = b.trial.evaluations();
  double limit = 0;
  for (const RegionPrice& r : all) limit = std::max(limit, r.error);
  limit *= 0.2;
  const auto some = price_regions(b.trial, b.analysis, limit, b.watch);
  EXPECT_LT(some.size(), all.size());
  EXPECT_GT(some.size(), 0u);
  for (const RegionPrice& r : some) EXPECT_LE(r.error, limit);
  EXPECT_EQ(b.trial.evaluations(), priced);  // known already
  Bench afresh(b.mesh);
  const auto same = price_regions(afresh.trial, afresh.analysis, limit, afresh.watch);
  ASSERT_EQ(same.size(), some.size());
  for (std::size_t i = 0; i < same.size(); ++i) {
    EXPECT_EQ(same[i].region, some[i].region);
    EXPECT_EQ(same[i].error, some[i].error);
  }
  EXPECT_LT(afresh.trial.evaluations(), priced);
}

// A mesh of n x n parts of one patch has about n^4 / 4 rectangles, all of them as good as free.
TEST(Regions, of_a_large_smooth_mesh_are_not_all_tried_and_the_largest_is_found) {
  const Mesh one = grid_mesh(
      {.rows = 1, .columns = 1, .position_noise = 0.2, .color_model = ColorModel::bicubic}, 4);
  for (const int n : {10, 16, 20}) {
    Bench b(build_mesh(subdivided(one, n)));
    const auto regions = price_regions(b.trial, b.analysis, 0.01, b.watch);
    ASSERT_FALSE(regions.empty());
    EXPECT_EQ(regions.back().region.size(), n * n);
    EXPECT_LT(b.trial.evaluations(), 32 * n * n);
  }
}

TEST(Regions, hold_junctions_where_they_hold_all_that_meets_there) {
  Mesh mesh = build_mesh(parts(1, 3, 1));
  Journal journal(mesh);
  split(journal, mesh.sides(Face{1})[1], 0.5);  // across the middle patch
  Bench b(mesh);
  std::multiset<int> sizes;
  for (const RegionPrice& r : price_regions(b.trial, b.analysis, 1, b.watch))
    sizes.insert(r.size());
  // The two halves, both with the patch on either side, and all.
  EXPECT_EQ(sizes, (std::multiset{2, 3, 3, 4}));
}

TEST(Regions, do_not_go_round_a_ring) {
  Bench b5(build_mesh(test::ring(5)));
  for (const RegionPrice& r : price_regions(b5.trial, b5.analysis, 1, b5.watch))
    EXPECT_LT(r.size(), 6);
}

TEST(MergeRegion, takes_exact_splits_out_again) {
  std::mt19937 random(11);
  const auto share = [&] { return 0.2 + 0.6 * double(random() % 1000) / 1000; };
  for (int trial = 0; trial < 20; ++trial) {
    const Mesh original = grid_mesh({.rows = 1,
                                     .columns = 1,
                                     .position_noise = 0.2,
                                     .color_noise = 0.3,
                                     .color_model = ColorModel::bicubic},
                                    trial);
    // The rest behind the first cut is cut in halves.
    const double u = share() * 0.5, v = share() * 0.5;
    Mesh mesh = build_mesh(test::cut_patch(original.patch(Face{0}), {0, u, 0.5 + 0.5 * u, 1},
                                           {0, v, 0.5 + 0.5 * v, 1}));
    Journal journal(mesh);
    const Region whole{Face{0}, 0, 3, 3};
    ASSERT_TRUE(merge_region(journal, whole).valid());
    EXPECT_EQ(mesh.face_count(), 1);
    EXPECT_EQ(journal.depth(), 8u);
    EXPECT_LT(test::difference(mesh.patch(*mesh.faces().begin()), original.patch(Face{0})), 1e-9);
    journal.undo_to(0);
    EXPECT_EQ(mesh.face_count(), 9);
  }
}

TEST(Motorcycle, cuts_the_mesh_into_rectangles) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    const Mesh mesh = build_mesh(parts(6, 7, seed));
    std::mt19937 random(seed);
    std::vector<EdgePrice> prices;
    for (const Halfedge edge : inner_edges(mesh))
      prices.push_back(
          {edge, MergeObstacle::none, random() % 10 == 0 ? 1.0 : 0.001 * double(random() % 9)});
    const MotorcycleGraph graph = motorcycle_graph(mesh, prices, 0.5);
    std::set<Halfedge> inside;
    double last = 0;
    for (const auto& part : graph.parts) {
      std::set<Face> faces;
      double sum = 0;
      for (const Halfedge edge : part) {
        EXPECT_TRUE(inside.insert(edge).second);
        faces.insert(mesh.face(edge));
        faces.insert(mesh.face(mesh[edge].twin));
        for (const EdgePrice& p : prices) sum += p.edge == edge ? p.error : 0;
      }
      // Faces are numbered row by row, seven in a row.
      int top = 6, bottom = 0, left = 7, right = 0;
      for (const Face f : faces) {
        top = std::min(top, f.value / 7), bottom = std::max(bottom, f.value / 7);
        left = std::min(left, f.value % 7), right = std::max(right, f.value % 7);
      }
      const int rows = bottom - top + 1, columns = right - left + 1;
      EXPECT_EQ(int(faces.size()), rows * columns);
      EXPECT_EQ(int(part.size()), rows * (columns - 1) + columns * (rows - 1));
      EXPECT_GE(sum, last);
      last = sum;
    }
    // Marked or inside, never both; nothing costly is inside.
    EXPECT_EQ(inside.size() + graph.costly.size() + graph.traced.size(), prices.size());
    for (const EdgePrice& p : prices) {
      if (p.error > 0.5) {
        EXPECT_FALSE(inside.contains(p.edge));
      }
    }
    const std::vector<Halfedge> order = motorcycle_order(mesh, graph, 3);
    EXPECT_EQ(order.size(), inside.size());
  }
}

TEST(Motorcycle, takes_the_shorter_of_two_paths) {
  const Mesh mesh = build_mesh(parts(3, 9, 1));
  // One costly edge that ends inside: between the patches 0 and 9 at the left end. Straight on
  // there are 8 edges more to the right end; across only 1 up and 2 down.
  std::vector<EdgePrice> prices;
  const Halfedge costly = test::between(mesh, Face{0}, Face{9});
  for (const Halfedge edge : inner_edges(mesh))
    prices.push_back({edge, MergeObstacle::none, edge == mesh.curve(costly) ? 1.0 : 0.0});
  const MotorcycleGraph graph = motorcycle_graph(mesh, prices, 0.5);
  EXPECT_EQ(graph.costly, std::vector{mesh.curve(costly)});
  EXPECT_EQ(graph.traced.size(), 3u);
}

TEST(Gqe, merges_disjoint_regions_within_epsilon_and_looking_ahead_is_never_worse) {
  for (unsigned seed = 0; seed < 12; ++seed)
    for (const double omega : {0.0, 0.75, 1.0}) {
      const Mesh original = test::changed_mesh(parts(5, 5, seed, 0.06), seed, 3);
      int patches[2];
      for (const bool look_ahead : {false, true}) {
        Bench b(original, 0.02);
        const auto regions = price_regions(b.trial, b.analysis, 0.02, b.watch);
        select_gqe(b.trial, regions, {omega, look_ahead}, b.watch);
        EXPECT_EQ(validate(b.mesh), std::vector<std::string>{});
        EXPECT_LE(b.trial.measure().whole_frame(b.mesh).mean, 0.02);
        EXPECT_LT(b.mesh.face_count(), original.face_count());
        patches[look_ahead] = b.mesh.face_count();
      }
      EXPECT_LE(patches[1], patches[0]);
    }
}

}  // namespace
}  // namespace gradmesh
