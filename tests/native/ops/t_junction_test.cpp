#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "branch_meshes.h"
#include "mesh/validate.h"
#include "ops/merge/merge_end.h"
#include "random_meshes.h"

/// Each case of the paper's 4.3 and 4.4 on a small mesh of its own.
namespace gradmesh {
namespace {

using test::between;
using test::difference;

/// One curved patch cut exactly at these places: every merge of its parts must give the part of
/// the whole that they cover, whatever T-junctions come and go.
class ExactGrid {
 public:
  ExactGrid(std::vector<double> rows, std::vector<double> columns)
      : rows_(std::move(rows)),
        columns_(std::move(columns)),
        mesh_(build_mesh(test::cut_patch(whole(), rows_, columns_))) {
    for (const Face f : mesh_.faces()) {
      const auto [i, j] = std::pair(f.value / width(), f.value % width());
      covered_.push_back({rows_[i], rows_[i + 1], columns_[j], columns_[j + 1]});
    }
  }

  const Mesh& mesh() const { return mesh_; }
  Halfedge edge(int a, int b) const { return between(mesh_, Face{a}, Face{b}); }

  /// Merges faces a and b at the half-edge between them that is in a's loop.
  void merge(int a, int b) {
    const Halfedge e = edge(a, b);
    ASSERT_TRUE(e.valid()) << a << " and " << b << " have no edge";
    ASSERT_EQ(can_merge(mesh_, e), MergeObstacle::none) << describe(can_merge(mesh_, e)).english();
    gradmesh::merge(journal_, e);
    ASSERT_EQ(validate(mesh_), std::vector<std::string>{});
    Rectangle& kept = covered_[a];
    const Rectangle& gone = covered_[b];
    kept = {std::min(kept.top, gone.top), std::max(kept.bottom, gone.bottom),
            std::min(kept.left, gone.left), std::max(kept.right, gone.right)};
    for (const Face f : mesh_.faces())
      EXPECT_LE(difference(mesh_.patch(f), part(covered_[f.value])), 1e-8) << "face " << f.value;
  }

  std::vector<Halfedge> parents() const {
    std::vector<Halfedge> result;
    for (const Halfedge h : mesh_.halfedges())
      if (mesh_.is_parent(h)) result.push_back(h);
    return result;
  }
  /// The parent with these faces along it.
  Halfedge parent_of(const std::vector<int>& faces) const {
    for (const Halfedge p : parents()) {
      std::vector<int> along;
      for (const Halfedge bar : mesh_.leaves(p)) along.push_back(mesh_.face(bar).value);
      if (along == faces) return p;
    }
    return {};
  }
  std::size_t points() const { return std::size_t(std::ranges::distance(mesh_.points())); }

  /// The curve u = const of the whole patch, from left to right.
  static Cubic<Value> across(double u) { return part({u, 1, 0, 1}).side(0); }

 private:
  struct Rectangle {
    double top, bottom, left, right;
  };

  static Patch whole() {
    return test::grid_parts({.rows = 1,
                             .columns = 1,
                             .position_noise = 0.15,
                             .color_noise = 0.2,
                             .color_model = ColorModel::bicubic},
                            3)
        .patches[0];
  }
  static Patch part(const Rectangle& r) {
    return whole().part_u(r.top, r.bottom).part_v(r.left, r.right);
  }
  int width() const { return int(columns_.size()) - 1; }

  std::vector<double> rows_, columns_;
  Mesh mesh_;
  Journal journal_{mesh_};
  std::vector<Rectangle> covered_;
};

/// Nine faces, none as wide as its neighbour.
ExactGrid three_by_three() { return {{0, 0.3, 0.6, 1}, {0, 0.2, 0.7, 1}}; }

// --- Fig. 4a: T-junctions are inserted ---

TEST(Fig4a, an_edge_inside_the_mesh_gets_a_junction_at_both_ends) {
  ExactGrid grid = three_by_three();
  grid.merge(3, 4);
  const Mesh& mesh = grid.mesh();
  ASSERT_EQ(grid.parents().size(), 2u);
  EXPECT_EQ(grid.points(), 16u);
  // Above, the parent runs along the bottoms of 1 and 0, below along the tops of 6 and 7.
  for (const auto& [faces, t, stem_face] :
       {std::tuple(std::vector{1, 0}, 0.5 / 0.7, 0), std::tuple(std::vector{6, 7}, 0.2 / 0.7, 7)}) {
    const Halfedge parent = grid.parent_of(faces);
    ASSERT_TRUE(parent.valid());
    const std::vector<Halfedge> children = mesh.children(parent).list();
    ASSERT_EQ(children.size(), 3u);
    EXPECT_TRUE(mesh.is_stem(children[1]));
    EXPECT_NEAR(mesh[children[0]].interval.second, t, 1e-9);
    EXPECT_NEAR(mesh[children[1]].interval.first, t, 1e-9);
    EXPECT_NEAR(mesh[children[2]].interval.first, t, 1e-9);
    EXPECT_EQ(mesh.face(mesh[parent].twin), Face{3});
  }
}

TEST(Fig4a, at_the_boundary_the_point_goes_and_no_junction_comes) {
  ExactGrid grid({0, 1}, {0, 0.3, 1});
  EXPECT_EQ(grid.points(), 6u);
  grid.merge(0, 1);
  EXPECT_TRUE(grid.parents().empty());
  EXPECT_EQ(grid.points(), 4u);
}

// --- Fig. 4b: T-junctions are removed ---

TEST(Fig4b, with_two_bars_the_parent_takes_their_place) {
  ExactGrid grid({0, 0.4, 1}, {0, 0.3, 1});
  grid.merge(0, 1);
  const Halfedge parent = grid.parent_of({2, 3});
  ASSERT_TRUE(parent.valid());
  const Cubic<Value> curve = grid.mesh().curve_of(parent);
  grid.merge(2, 3);
  EXPECT_TRUE(grid.parents().empty());
  EXPECT_TRUE(grid.mesh().is_leaf(parent));
  EXPECT_EQ(grid.mesh().face(parent), Face{2});
  EXPECT_EQ(grid.mesh().curve_of(parent), curve);
}

TEST(Fig4b, with_more_bars_two_become_one) {
  ExactGrid grid({0, 0.4, 1}, {0, 0.2, 0.7, 1});
  grid.merge(0, 1);
  grid.merge(0, 2);
  const Halfedge parent = grid.parent_of({3, 4, 5});
  ASSERT_TRUE(parent.valid());
  const Cubic<Value> curve = grid.mesh().curve_of(parent);
  const auto bars = [&] { return grid.mesh().leaves(parent).list(); };
  const double end = grid.mesh()[bars()[1]].interval.second;
  EXPECT_NEAR(end, 0.7, 1e-9);
  grid.merge(3, 4);
  ASSERT_EQ(bars().size(), 2u);
  EXPECT_EQ(grid.mesh()[bars()[0]].interval, (Interval{0, end}));
  EXPECT_EQ(grid.mesh()[bars()[1]].interval, (Interval{end, 1}));
  EXPECT_EQ(grid.mesh().curve_of(parent), curve);
}

// --- Fig. 4c: parents are combined ---

/// Eq. 6 as the paper writes it.
double eq6(double t, double s, double q) {
  const double r1 = (1 - t) / t * s, r2 = (1 - q) / q * r1;
  return 1 / (1 + r1 + r2);
}

/// The merge of faces a and b combines the curves above them into the whole curve at `u`.
void expect_combined(ExactGrid& grid, double u, int a, int b, double s, double q, double expected) {
  const Mesh& mesh = grid.mesh();
  const Halfedge edge = grid.edge(a, b);
  const MergeEnd end = merge_end(mesh, edge);
  ASSERT_EQ(end.kind, MergeEnd::interior);
  EXPECT_NEAR(mesh.span(end.in).length(), s, 1e-9);
  EXPECT_NEAR(mesh.span(end.out).length(), q, 1e-9);
  const double t = eq6(test::split_factor(mesh, edge), s, q);
  EXPECT_NEAR(t, expected, 1e-9);
  const Halfedge across = end.across;

  grid.merge(a, b);
  // The curve across is the new stem; its T-junction lies on the other side of the curve.
  ASSERT_TRUE(mesh.is_stem(across));
  EXPECT_NEAR(1 - mesh[across].interval.first, t, 1e-9);
  const Halfedge parent = mesh[mesh[across].parent].twin;
  const Cubic<Value> curve = mesh.curve_of(parent), whole = grid.across(u);
  for (const Value& d :
       {curve.p0 - whole.p0, curve.m0 - whole.m0, curve.m1 - whole.m1, curve.p1 - whole.p1})
    EXPECT_LE(std::max(glm::length(d.position), glm::length(d.color)), 1e-8);
}

TEST(Fig4c, the_side_before_is_a_bar) {
  ExactGrid grid({0, 0.4, 1}, {0, 0.2, 0.7, 1});
  grid.merge(0, 1);
  expect_combined(grid, 0.4, 4, 5, 0.5 / 0.7, 1, 0.7);
}

TEST(Fig4c, the_side_after_is_a_bar) {
  ExactGrid grid({0, 0.4, 1}, {0, 0.2, 0.7, 1});
  grid.merge(1, 2);
  expect_combined(grid, 0.4, 3, 4, 1, 0.5 / 0.8, 0.2);
}

TEST(Fig4c, both_sides_are_bars_of_different_parents) {
  ExactGrid grid({0, 0.4, 1}, {0, 0.2, 0.5, 0.8, 1});
  grid.merge(0, 1);
  grid.merge(2, 3);
  expect_combined(grid, 0.4, 5, 6, 0.3 / 0.5, 0.3 / 0.5, 0.5);
  EXPECT_EQ(grid.mesh().leaves(grid.parent_of({4, 5, 7})).list().size(), 3u);
}

TEST(Fig4c, both_sides_are_whole_curves_that_are_divided_on_the_far_side) {
  ExactGrid grid({0, 0.3, 0.6, 1}, {0, 0.2, 0.5, 0.8, 1});
  // Above the middle row now lie two faces beside each face of the middle row.
  grid.merge(4, 5);
  grid.merge(6, 7);
  expect_combined(grid, 0.3, 4, 6, 1, 1, 0.5);
  EXPECT_EQ(grid.mesh().leaves(grid.parent_of({3, 2, 1, 0})).list().size(), 4u);
}

// --- Fig. 5: cycles ---

/// Three sides of a pinwheel round the middle face of a 3 x 3 grid; the fourth would close it.
TEST(Fig5, cycles_are_refused) {
  ExactGrid next = three_by_three(), origin = three_by_three();
  for (const auto& [a, b] : {std::pair(0, 1), {2, 5}, {8, 7}}) next.merge(a, b);
  EXPECT_EQ(can_merge(next.mesh(), next.edge(6, 3)), MergeObstacle::next_cycle);
  for (const auto& [a, b] : {std::pair(1, 2), {5, 8}, {7, 6}}) origin.merge(a, b);
  EXPECT_EQ(can_merge(origin.mesh(), origin.edge(3, 0)), MergeObstacle::origin_cycle);
}

/// Seen in a mirror: sides 1 and 3 of each patch change places, and the order along each side.
MeshParts mirrored(MeshParts parts) {
  const glm::dvec2 mirror(-1, 1);
  for (Patch& patch : parts.patches)
    patch = test::quad(patch.corner(1).position * mirror, patch.corner(0).position * mirror,
                       patch.corner(3).position * mirror, patch.corner(2).position * mirror);
  for (CurveParts& curve : parts.curves)
    for (CurveSide* side : {&curve.a, &curve.b}) {
      for (int& h : side->halfedges) h = h % 2 ? h ^ 2 : h;
      std::ranges::reverse(side->halfedges);
    }
  return parts;
}

TEST(Fig5, a_mesh_with_a_cycle_cannot_be_built) {
  for (const MeshParts& parts : {test::pinwheel(), mirrored(test::pinwheel())}) {
    try {
      build_mesh(parts);
      ADD_FAILURE() << "it was built";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("a curve hangs on itself"), std::string::npos)
          << error.what();
    }
  }
}

// --- Fig. 6: branches ---

void expect_all_refused(const MeshParts& parts, MergeObstacle obstacle) {
  const Mesh mesh = build_mesh(parts);
  EXPECT_EQ(validate(mesh), std::vector<std::string>{});
  int edges = 0;
  for (const Halfedge h : mesh.halfedges())
    if (mesh[h].twin.valid()) {
      EXPECT_EQ(can_merge(mesh, h), obstacle);
      ++edges;
    }
  EXPECT_EQ(edges, 2 * int(parts.curves.size()));
}

TEST(Fig6, an_l_branch_stays) { expect_all_refused(test::l_branch(), MergeObstacle::branch); }
TEST(Fig6, a_u_branch_stays) { expect_all_refused(test::u_branch(), MergeObstacle::branch); }

// --- meshes that are no rectangle ---

/// Merges in random orders until nothing more can be; returns how few faces were left.
int fewest_faces(const MeshParts& parts) {
  int fewest = int(parts.patches.size());
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    Mesh mesh = build_mesh(parts);
    Journal journal(mesh);
    for (auto edges = test::mergeable_edges(mesh); !edges.empty();
         edges = test::mergeable_edges(mesh)) {
      merge(journal, edges[random() % edges.size()]);
      EXPECT_EQ(validate(mesh), std::vector<std::string>{});
    }
    fewest = std::min(fewest, mesh.face_count());
    journal.undo_to(0);
    EXPECT_EQ(test::patches(mesh), test::patches(build_mesh(parts)));
  }
  return fewest;
}

bool has_corner(const Mesh& mesh) {
  const auto on_boundary = [&](Halfedge h) { return !mesh.other_side(h).valid(); };
  return std::ranges::any_of(mesh.halfedges(), [&](Halfedge h) {
    return mesh.is_leaf(h) && on_boundary(h) && on_boundary(mesh.next(h));
  });
}

TEST(Topology, the_arms_of_a_cross_shrink_but_its_branch_points_stay) {
  EXPECT_EQ(fewest_faces(test::cross(3)), 5);
}

TEST(Topology, components_are_merged_each_for_itself) {
  EXPECT_EQ(fewest_faces(test::two_components()), 2);
}

TEST(Topology, a_closed_ring_has_no_corner_and_shrinks_to_one_face) {
  EXPECT_FALSE(has_corner(build_mesh(test::ring(5))));
  EXPECT_EQ(fewest_faces(test::ring(5)), 1);
}

TEST(Topology, a_tree_of_rings_has_no_corner_and_keeps_its_branch_points) {
  EXPECT_FALSE(has_corner(build_mesh(test::dumbbell())));
  // Of each ring the patch at the strip and all others as one; the strip as one.
  EXPECT_EQ(fewest_faces(test::dumbbell()), 5);
}

}  // namespace
}  // namespace gradmesh
