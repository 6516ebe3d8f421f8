// Blocks with few handles (methods/best/handle_drops.h): what is merged and fitted stays plain, or
// becomes so.
#include <gtest/gtest.h>

#include "base/parallel.h"
#include "fit/plainness.h"
#include "form/handles.h"
#include "mesh/validate.h"
#include "meshes.h"
#include "simplify/simplify.h"

namespace gradmesh {
namespace {

RunOptions options_for(Count count) {
  RunOptions options;
  options.method = best_method;
  options.count = count;
  options.resolution = 150;
  options.epsilon = 0.02;
  options.max_local_error = 0.15;
  return options;
}

Mesh curved_mesh(unsigned seed) {
  return test::grid_mesh({.rows = 5, .columns = 5, .position_noise = 0.05, .color_noise = 0.05},
                         seed);
}

TEST(FewHandles, never_more_than_before_and_fewer_than_where_patches_are_few) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const Mesh original = curved_mesh(seed);
    Mesh of_few_patches = original, mesh = original;
    const SimplifyResult patches = simplify(of_few_patches, options_for(Count::patches));
    const SimplifyResult handles = simplify(mesh, options_for(Count::handles));
    EXPECT_EQ(validate(mesh), std::vector<std::string>{});
    EXPECT_EQ(handles.handles_before, count_handles(original));
    EXPECT_EQ(handles.handles_after, count_handles(mesh));
    EXPECT_LT(handles.handles_after, handles.handles_before) << "seed " << seed;
    EXPECT_LT(handles.handles_after, patches.handles_after) << "seed " << seed;
    EXPECT_GE(handles.patches_after, patches.patches_after) << "seed " << seed;
    EXPECT_LE(handles.error, 0.02);
    EXPECT_LE(handles.local_error, 0.15);
  }
}

TEST(FewHandles, nothing_is_changed_where_no_handle_can_go) {
  Mesh mesh = test::grid_mesh({.rows = 2, .columns = 2, .color_noise = 0.5}, 3);
  RunOptions options = options_for(Count::handles);
  options.epsilon = 0;
  options.max_local_error = 0;
  const Mesh before = mesh;
  const SimplifyResult result = simplify(mesh, options);
  EXPECT_FALSE(result.changed);
  EXPECT_EQ(mesh, before);
}

TEST(FewHandles, the_same_for_any_number_of_threads) {
  RunOptions options = options_for(Count::handles);
  Mesh one = curved_mesh(1), three = curved_mesh(1);
  options.threads = 1;
  simplify(one, options);
  options.threads = 3;
  simplify(three, options);
  EXPECT_EQ(one, three);
}

/// Splits of a mesh that is straight leave it so.
TEST(FewHandles, what_was_straight_is_merged_to_straight_sides) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    Mesh mesh = test::grid_mesh({.rows = 4, .columns = 4, .color_noise = 0.02}, seed);
    simplify(mesh, options_for(Count::handles));
    const Plainness plain(mesh);
    for (const Face f : mesh.faces()) EXPECT_TRUE(plain.is_coons(f)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace gradmesh
