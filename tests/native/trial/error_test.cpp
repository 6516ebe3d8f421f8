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

/// A grid of which a corner has another colour, or whose last row is gone.
TEST(MeasuredSurface, near_another_has_the_error_of_the_whole) {
  for (const MetricKind metric : {MetricKind::flip, MetricKind::ssim})
    for (unsigned seed = 0; seed < 8; ++seed) {
      const test::GridOptions options{
          .rows = 5, .columns = 4, .position_noise = 0.1, .color_noise = 0.3};
      MeshParts parts = test::grid_parts(options, seed);
      const Mesh mesh = build_mesh(parts);
      const Frame frame = fit_frame(mesh, {}, 180);
      const auto reference = test::reference(mesh, frame, metric);
      const LocalBound bound(0.05, Plane(frame.width, frame.height));
      const MeasuredSurface start(*reference, mesh, false, &bound, true);
      EXPECT_EQ(start.error().mean, 0);
      if (seed % 2 == 0) {
        // The corner of the grid, which is of this patch alone.
        parts.patches[0].c[0][0].color = glm::dvec4(1, 0, seed / 8.0, 1);
      } else {
        parts.patches.resize(parts.patches.size() - options.columns);
        parts.curves = grid_curves(options.rows - 1, options.columns);
      }
      const Mesh other = build_mesh(parts);
      const FrameError whole = MeasuredSurface(*reference, other, false, &bound, true).error();
      const FrameError near = MeasuredSurface(start, *reference, other, &bound).error();
      ASSERT_GT(whole.mean, 0);
      EXPECT_NEAR(near.mean, whole.mean, 1e-12);
      EXPECT_EQ(near.local, whole.local);
      EXPECT_EQ(near.detail, whole.detail);
      EXPECT_EQ(near.keeps_local_bound, whole.keeps_local_bound);
      const double limit = whole.mean / 2;
      const FrameError cut = MeasuredSurface(start, *reference, other, &bound, limit).error();
      EXPECT_GT(cut.mean, limit);
      EXPECT_FALSE(cut.keeps_local_bound);
    }
}

/// White that is more or less translucent looks alike on white.
TEST(MeasuredSurface, small_parts_are_measured_on_black_too) {
  MeshParts parts = test::grid_parts({.rows = 4, .columns = 4});
  const auto whiten = [&](double opacity) {
    for (Patch& patch : parts.patches) {
      for (auto& row : patch.c)
        for (Value& value : row) value.color = glm::dvec4(0);
      for (const int i : {0, 3})
        for (const int j : {0, 3}) patch.c[i][j].color = glm::dvec4(1, 1, 1, opacity);
    }
    return build_mesh(parts);
  };
  const Mesh mesh = whiten(0.5);
  const auto reference = test::reference(mesh, fit_frame(mesh, {}, 100), MetricKind::flip);
  const LocalBound bound(0.05, Plane(reference->frame().width, reference->frame().height));
  const MeasuredSurface start(*reference, mesh, false, &bound, true);
  EXPECT_EQ(start.error().local, 0);
  const Mesh clearer = whiten(0.3);
  const MeasuredSurface whole(*reference, clearer, false, &bound, true),
      near(start, *reference, clearer, &bound);
  for (const FrameError& error : {whole.error(), near.error()}) {
    EXPECT_EQ(error.mean, 0);
    EXPECT_GT(error.local, 0.1);
    EXPECT_GT(error.detail, 0.1);
    EXPECT_FALSE(error.keeps_local_bound);
  }
  EXPECT_EQ(*std::ranges::max_element(whole.details().samples), float(whole.error().detail));
}

}  // namespace
}  // namespace gradmesh
