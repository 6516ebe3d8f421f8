// Lines through a whole mesh, and meshes with T-junctions as plain grids (ops/split/split_line.h).
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "mesh/rectangle.h"
#include "mesh/subdivide.h"
#include "mesh/validate.h"
#include "meshes.h"
#include "ops/merge/merge_faces.h"
#include "ops/split/split.h"
#include "ops/split/split_line.h"
#include "random_meshes.h"

namespace gradmesh {
namespace {

using test::changed_mesh;
using test::grid_mesh;
using test::grid_parts;

Mesh plain(const Mesh& mesh) { return build_mesh(subdivided(mesh, 1)); }

/// How far a place is from a patch: from the closest of some samples on, in ever smaller steps.
double distance(const Patch& patch, glm::dvec2 place) {
  glm::dvec2 at(0);
  const auto distance_at = [&](glm::dvec2 uv) {
    const bool inside = uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1;
    return inside ? glm::length(patch.at(uv.x, uv.y).position - place) : 1e9;
  };
  double closest = distance_at(at);
  const auto try_at = [&](glm::dvec2 uv) {
    if (const double d = distance_at(uv); d < closest) {
      closest = d;
      at = uv;
      return true;
    }
    return false;
  };
  for (int i = 0; i <= 16; ++i)
    for (int j = 0; j <= 16; ++j) try_at(glm::dvec2(i, j) / 16.0);
  for (double step = 1.0 / 16; step > 1e-9;) {
    bool closer = false;
    for (const int i : {-1, 0, 1})
      for (const int j : {-1, 0, 1}) closer |= try_at(at + step * glm::dvec2(i, j));
    if (!closer) step /= 2;
  }
  return closest;
}

/// The middle of every patch of `fine` lies on a patch of `coarse`.
void expect_same_surface(const Mesh& coarse, const Mesh& fine) {
  for (const Face f : fine.faces()) {
    const glm::dvec2 middle = fine.patch(f).at(0.5, 0.5).position;
    double closest = 1e9;
    for (const Face c : coarse.faces())
      closest = std::min(closest, distance(coarse.patch(c), middle));
    EXPECT_LT(closest, 1e-6);
  }
}

TEST(SplitLine, crosses_a_grid_and_leaves_a_grid) {
  Mesh mesh = grid_mesh({.rows = 3, .columns = 4, .position_noise = 0.1});
  Journal journal(mesh);
  split_line_across(journal, mesh.sides(Face{5})[0], 0.3);
  EXPECT_EQ(mesh.face_count(), 15);
  EXPECT_EQ(validate(mesh), std::vector<std::string>{});
  const Mesh after = plain(mesh);
  const auto grid = find_grid(after);
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->rows, 3);
  EXPECT_EQ(grid->columns, 5);
}

TEST(SplitLine, ends_at_the_boundary_in_one_direction_alone) {
  Mesh mesh = grid_mesh({.rows = 3, .columns = 4});
  Journal journal(mesh);
  split_line(journal, mesh.sides(Face{5})[0], 0.3);  // in the second row: two patches
  EXPECT_EQ(mesh.face_count(), 14);
}

TEST(SplitLine, joins_a_line_that_is_there) {
  Mesh mesh = grid_mesh({.rows = 2, .columns = 1});
  Journal journal(mesh);
  split(journal, mesh.sides(Face{1})[0], 0.25);
  split_line(journal, mesh.sides(Face{0})[0], 0.25);
  EXPECT_EQ(mesh.face_count(), 4);
  const Mesh after = plain(mesh);
  ASSERT_TRUE(find_grid(after));
  EXPECT_EQ(find_grid(after)->columns, 2);
}

TEST(ExtendStems, any_mesh_of_merged_and_split_patches_becomes_a_grid_again) {
  int with_junctions = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const Mesh before =
        changed_mesh(grid_parts({.rows = 4, .columns = 4, .position_noise = 0.05}, seed), seed, 12);
    with_junctions += !find_grid(before);
    Mesh mesh = before;
    Journal journal(mesh);
    extend_stems(journal, 100000);
    EXPECT_EQ(validate(mesh), std::vector<std::string>{});
    const Mesh after = plain(mesh);
    EXPECT_EQ(validate(after), std::vector<std::string>{});
    const auto grid = find_grid(after);
    ASSERT_TRUE(grid) << "seed " << seed;
    EXPECT_EQ(grid->rows * grid->columns, after.face_count());
    if (seed <= 5) expect_same_surface(before, after);
  }
  EXPECT_GT(with_junctions, 30);
}

TEST(ExtendStems, a_grid_stays) {
  Mesh mesh = grid_mesh();
  Journal journal(mesh);
  extend_stems(journal, 9);
  EXPECT_EQ(journal.depth(), 0u);
}

TEST(ExtendStems, says_where_it_would_take_too_many) {
  Mesh mesh = grid_mesh({.rows = 3, .columns = 3});
  Journal journal(mesh);
  split(journal, mesh.sides(Face{0})[0], 0.5);
  EXPECT_THROW(extend_stems(journal, 10), InputError);
}

std::vector<Face> faces(std::initializer_list<int> numbers) {
  std::vector<Face> result;
  for (const int n : numbers) result.push_back(Face{n});
  return result;
}

TEST(MergeFaces, rectangles_of_any_size) {
  for (const auto& chosen : {faces({0, 1}), faces({0, 3}), faces({4, 5, 7, 8}),
                             faces({8, 7, 6, 5, 4, 3, 2, 1, 0}), faces({4})}) {
    Mesh mesh = grid_mesh({.rows = 3, .columns = 3, .position_noise = 0.1});
    Journal journal(mesh);
    const MergedFaces merged = merge_faces(journal, chosen);
    ASSERT_TRUE(merged.face.valid());
    EXPECT_EQ(mesh.face_count(), 10 - int(chosen.size()));
    EXPECT_EQ(validate(mesh), std::vector<std::string>{});
  }
}

TEST(MergeFaces, says_why_not_and_changes_nothing) {
  Mesh mesh = grid_mesh({.rows = 3, .columns = 3, .position_noise = 0.1});
  Journal journal(mesh);
  EXPECT_EQ(merge_faces(journal, faces({0, 4})).obstacle, MergeObstacle::none);  // apart
  EXPECT_FALSE(merge_faces(journal, faces({0, 4})).face.valid());
  // Three patches round a corner: two become one, and the third lies along a part of its side.
  const MergedFaces corner = merge_faces(journal, faces({0, 1, 3}));
  EXPECT_FALSE(corner.face.valid());
  EXPECT_TRUE(corner.obstacle == MergeObstacle::parent || corner.obstacle == MergeObstacle::bar);
  EXPECT_EQ(mesh.face_count(), 9);
  EXPECT_EQ(journal.depth(), 0u);
}

}  // namespace
}  // namespace gradmesh
