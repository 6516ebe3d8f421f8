// Patches that must stay as they are (Mesh::is_fixed), whatever a method makes of the others.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <random>

#include "app/document/svg_rules.h"
#include "form/written_patch.h"
#include "mesh/build.h"
#include "mesh/faces_under.h"
#include "mesh/subdivide.h"
#include "mesh/validate.h"
#include "meshes.h"
#include "methods/method.h"
#include "ops/fix.h"
#include "ops/merge/merge.h"
#include "problems.h"
#include "random_meshes.h"
#include "simplify/state_curve.h"

namespace gradmesh {
namespace {

Mesh mesh_for(unsigned seed) {
  std::mt19937 random(seed);
  MeshParts parts = test::grid_parts(
      {.rows = 6, .columns = 6, .position_noise = 0.03, .color_noise = 0.02}, random);
  for (Patch& patch : parts.patches) {
    make_coons(patch);
    patch = as_written(patch, 0);
  }
  return build_mesh(parts);
}

std::vector<Face> some_faces(const Mesh& mesh, unsigned seed, int count) {
  std::mt19937 random(seed);
  std::vector<Face> all;
  for (const Face f : mesh.faces()) all.push_back(f);
  std::ranges::shuffle(all, random);
  all.resize(std::size_t(count));
  return all;
}

std::vector<Patch> fixed_patches(const Mesh& mesh) {
  std::vector<Patch> patches;
  for (const Face f : mesh.faces())
    if (mesh.is_fixed(f)) patches.push_back(mesh.patch(f));
  return patches;
}

/// Whether a surface has a patch to the bit, from whichever side it begins.
bool has_patch(const Mesh& surface, const Patch& patch) {
  for (const Face f : surface.faces())
    for (const Halfedge side : surface.sides(f)) {
      const Patch other = surface.patch(side);
      if (std::memcmp(&other, &patch, sizeof patch) == 0) return true;
    }
  return false;
}

/// Returns the least difference of a patch of the surface, from whichever side it begins.
double nearest(const Mesh& surface, const Patch& patch) {
  double least = std::numeric_limits<double>::infinity();
  for (const Face f : surface.faces())
    for (const Halfedge side : surface.sides(f))
      least = std::min(least, test::difference(surface.patch(side), patch));
  return least;
}

RunOptions options_for(const std::string& method) {
  RunOptions options;
  options.method = method;
  options.resolution = 150;
  options.epsilon = 0.03;
  options.kappa = 1;
  options.rules = block_rules();
  options.gradient_rules = gradient_rules({});
  return options;
}

class EachMethod : public testing::TestWithParam<std::string> {};

TEST_P(EachMethod, leaves_fixed_patches_to_the_bit) {
  int changed = 0;
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Mesh start = mesh_for(seed);
    Mesh mesh = with_fixed(start, some_faces(start, seed, 1 + int(seed) % 3));
    const std::vector<Patch> fixed = fixed_patches(mesh);
    const RunOptions options = options_for(GetParam());
    const SimplifyResult result = simplify(mesh, options);
    changed += result.changed;
    EXPECT_EQ(validate(mesh), std::vector<std::string>{});
    ASSERT_EQ(fixed_patches(mesh).size(), fixed.size()) << seed;
    for (const Patch& patch : fixed) EXPECT_TRUE(has_patch(mesh, patch)) << "seed " << seed;
    // As written, whether one gradient or blocks.
    for (const Patch& patch : fixed)
      EXPECT_LE(nearest(result.surface(), patch), 1e-10) << "seed " << seed;
  }
  EXPECT_GT(changed, 0) << "nothing was made simpler at all";
}

INSTANTIATE_TEST_SUITE_P(Methods, EachMethod,
                         testing::Values("random", "grid", "dual-grid", "motorcycle", "gqe", "gqe1",
                                         "best", "lines", "plain"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(Fixed, no_merge_touches_a_fixed_patch_of_any_mesh) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    std::mt19937 random(seed);
    const MeshParts parts = test::grid_parts(
        {.rows = 4, .columns = 4, .position_noise = 0.05, .color_noise = 0.2}, random);
    const Mesh start = test::changed_mesh(parts, seed, 12);
    Mesh mesh = with_fixed(start, some_faces(start, seed, 2));
    const std::vector<Patch> fixed = fixed_patches(mesh);
    Journal journal(mesh);
    for (;;) {
      const std::vector<Halfedge> edges = test::mergeable_edges(mesh);
      if (edges.empty()) break;
      merge(journal, edges[random() % edges.size()]);
      for (const Patch& patch : fixed) ASSERT_TRUE(has_patch(mesh, patch)) << "seed " << seed;
    }
  }
}

TEST(Fixed, each_state_of_a_curve_has_the_fixed_patches) {
  const Mesh start = mesh_for(9);
  const Mesh mesh = with_fixed(start, some_faces(start, 9, 3));
  const std::vector<Patch> fixed = fixed_patches(mesh);
  const Problem problem = test::problem(mesh, options_for("plain"));
  StopWatch watch(0, {});
  for (const CurveState& state : find_curve(problem, MeshKind::one_gradient, watch).states)
    for (const Patch& patch : fixed) EXPECT_TRUE(has_patch(*state.mesh, patch));
}

TEST(Fixed, survives_parts) {
  const Mesh start = mesh_for(2);
  const Mesh mesh = with_fixed(start, some_faces(start, 2, 3));
  EXPECT_EQ(fixed_patches(build_mesh(subdivided(mesh, 1))).size(), 3u);
  EXPECT_EQ(fixed_patches(build_mesh(subdivided(mesh, 2))).size(), 12u);
  EXPECT_FALSE(start.has_fixed_faces());
  EXPECT_TRUE(mesh.has_fixed_faces());
}

TEST(Fixed, faces_under_an_area_are_those_of_which_it_covers_something) {
  const Mesh mesh = test::grid_mesh({.rows = 4, .columns = 4}, 1);
  const auto under = [&](double x0, double y0, double x1, double y1) {
    return faces_under(mesh, {{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}}}).size();
  };
  EXPECT_EQ(under(-10, -10, 410, 410), 16u);
  EXPECT_EQ(under(110, 110, 190, 190), 1u);
  EXPECT_EQ(under(100, 100, 200, 200), 1u) << "along its border";
  EXPECT_EQ(under(98, 98, 202, 202), 1u) << "and a hair beyond";
  EXPECT_EQ(under(90, 90, 210, 210), 9u);
  EXPECT_EQ(under(-50, -50, -10, -10), 0u);
}

}  // namespace
}  // namespace gradmesh
