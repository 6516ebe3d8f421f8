#include <gtest/gtest.h>

#include "problems.h"
#include "random_meshes.h"
#include "trial/edit_error.h"

namespace gradmesh {
namespace {

/// The windows of all edits together must give the number of the whole frame, whatever is merged,
/// split, accepted and taken back.
TEST(EditError, windows_add_up_to_the_whole_frame) {
  for (const MetricKind metric : {MetricKind::flip, MetricKind::ssim})
    for (unsigned seed = 0; seed < 12; ++seed) {
      std::mt19937 random(seed);
      Mesh mesh = test::grid_mesh(
          {.rows = 5, .columns = 4, .position_noise = 0.1, .color_noise = 0.3}, seed);
      const Frame frame = fit_frame(mesh, {}, 180);
      EditError error = test::edit_error(mesh, mesh, frame, metric);
      EXPECT_EQ(error.error(), 0);
      Journal journal(mesh);
      for (int step = 0; step < 25; ++step) {
        test::change_at_random(journal, random);
        const double before = error.error();
        const double after = error.after_edits(journal, journal.depth() - 1);
        ASSERT_NEAR(after, error.whole_frame(mesh).mean, 1e-9)
            << "seed " << seed << " step " << step;
        if (random() % 2 == 0) {
          error.accept(journal);
          EXPECT_EQ(error.error(), after);
        } else {
          journal.undo();
          EXPECT_EQ(error.error(), before);
          ASSERT_NEAR(before, error.whole_frame(mesh).mean, 1e-9);
        }
      }
      EXPECT_GT(error.error(), 0);
    }
}

TEST(EditError, an_exact_split_costs_nothing_visible) {
  Mesh mesh = test::grid_mesh({.position_noise = 0.1, .color_noise = 0.3}, 2);
  EditError error = test::edit_error(mesh, mesh, fit_frame(mesh, {}, 300), MetricKind::flip);
  Journal journal(mesh);
  split(journal, mesh.sides(Face{4})[1], 0.5);
  // The colour at the new points is rounded to 8 bits, as it will be written.
  EXPECT_LT(error.after_edits(journal, journal.depth() - 1), 0.002);
}

}  // namespace
}  // namespace gradmesh
