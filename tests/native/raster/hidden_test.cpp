// What an object's outline hides does not count (raster/hidden.h).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/power_of_ten.h"
#include "metric/metric.h"
#include "problems.h"
#include "random_meshes.h"
#include "raster/hidden.h"
#include "trial/edit_error.h"

namespace gradmesh {
namespace {

using Runs = std::vector<HiddenPixels::Run>;

VisibleArea inside(const Outline& outline, FillRule rule = FillRule::nonzero) {
  return {{{{outline, rule}}}};
}

TEST(HiddenPixels, all_that_a_rectangle_does_not_touch) {
  const HiddenPixels hidden(inside({{{2, 1.2}, {5.5, 1.2}, {5.5, 2.8}, {2, 2.8}}}), Frame{8, 4});
  EXPECT_EQ(hidden.row(0), (Runs{{0, 8}}));
  EXPECT_EQ(hidden.row(1), (Runs{{0, 2}, {6, 8}}));
  EXPECT_EQ(hidden.row(2), (Runs{{0, 2}, {6, 8}}));
  EXPECT_EQ(hidden.row(3), (Runs{{0, 8}}));
}

TEST(HiddenPixels, holes_follow_the_fill_rule) {
  const Outline ring{{{0, 0}, {9, 0}, {9, 1}, {0, 1}}, {{3, 0}, {6, 0}, {6, 1}, {3, 1}}};
  EXPECT_EQ(HiddenPixels(inside(ring, FillRule::evenodd), Frame{9, 1}).row(0), (Runs{{3, 6}}));
  EXPECT_EQ(HiddenPixels(inside(ring), Frame{9, 1}).row(0), Runs{});
}

TEST(HiddenPixels, seen_is_what_some_outline_of_each_set_holds) {
  const auto columns = [](double from, double to) {
    return FilledOutline{{{{from, 0}, {to, 0}, {to, 1}, {from, 1}}}};
  };
  const VisibleArea area{{{columns(0, 3), columns(5, 9)}, {columns(2, 7)}}};
  EXPECT_EQ(HiddenPixels(area, Frame{9, 1}).row(0), (Runs{{0, 2}, {3, 5}, {7, 9}}));
  EXPECT_EQ(HiddenPixels({{{}}}, Frame{9, 1}).row(0), (Runs{{0, 9}}));
  EXPECT_EQ(HiddenPixels({}, Frame{9, 1}).row(0), Runs{});
}

TEST(HiddenPixels, outlines_of_any_size_hide_as_those_near_the_frame_do) {
  for (int power = -9; power <= 9; ++power) {
    const double size = power_of_ten(power), far = std::max(size, 8.0);
    // To the left of x = 3, above and below as far as it goes; its sides begin beyond the frame.
    const Outline left{{{3, -far}, {3, far}, {-far, far}, {-far, -far}}};
    EXPECT_EQ(HiddenPixels(inside(left), Frame{8, 2}).row(1), (Runs{{3, 8}})) << size;
    const Outline beyond{{{2, 8 + size}, {5, 8 + size}, {5, 9 + 2 * size}, {2, 9 + 2 * size}}};
    EXPECT_EQ(HiddenPixels(inside(beyond), Frame{8, 2}).row(1), (Runs{{0, 8}})) << size;
    // A small mesh enlarges everything else.
    Frame frame{8, 2};
    frame.to_pixels = Affine::scaling(glm::dvec2(1 / size));
    const Outline object{{{-1e9, -1e9}, {5 * size, -1e9}, {5 * size, 1e9}, {-1e9, 1e9}}};
    EXPECT_EQ(HiddenPixels(inside(object), frame).row(0), (Runs{{5, 8}})) << size;
  }
  const double none = std::nan("");
  const HiddenPixels hidden(inside({{{none, 0}, {5, none}, {5, 2}}}), Frame{8, 2});
  EXPECT_TRUE(hidden.contains(7, 1));
}

/// Against each pixel's own distance to a circle.
TEST(HiddenPixels, a_pixel_is_hidden_where_the_outline_stays_away) {
  std::vector<glm::dvec2> circle;
  for (int i = 0; i < 2000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 2000;
    circle.push_back({50.3 + 40 * std::cos(angle), 49.8 + 40 * std::sin(angle)});
  }
  const HiddenPixels hidden(inside({circle}), Frame{100, 100});
  int seen = 0;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x) {
      const bool is_hidden = hidden.contains(x, y);
      const double from_center = std::hypot(x + 0.5 - 50.3, y + 0.5 - 49.8);
      if (from_center < 40) {
        EXPECT_FALSE(is_hidden) << x << " " << y;
      }
      if (from_center > 40 + std::numbers::sqrt2 / 2) {
        EXPECT_TRUE(is_hidden) << x << " " << y;
      }
      seen += !is_hidden;
    }
  EXPECT_GT(seen, 1600 * std::numbers::pi);
}

TEST(HiddenPixels, windows_still_add_up_to_the_whole_frame) {
  for (const MetricKind metric : {MetricKind::flip, MetricKind::ssim}) {
    std::mt19937 random(3);
    Mesh mesh =
        test::grid_mesh({.rows = 5, .columns = 4, .position_noise = 0.1, .color_noise = 0.3}, 3);
    Frame frame = fit_frame(mesh, {}, 180);
    frame.hidden = std::make_shared<HiddenPixels>(
        inside({{{30, 40}, {350, 90}, {300, 480}, {120, 330}}}), frame);
    EditError error = test::edit_error(mesh, mesh, frame, metric);
    const Mesh original = mesh;
    Journal journal(mesh);
    for (int step = 0; step < 25; ++step) {
      test::change_at_random(journal, random);
      ASSERT_NEAR(error.after_edits(journal, journal.depth() - 1), error.whole_frame(mesh).mean,
                  1e-9);
      error.accept(journal);
    }
    EXPECT_GT(error.error(), 0);
    frame.hidden = nullptr;
    EXPECT_GT(test::edit_error(original, original, frame, metric).whole_frame(mesh).mean,
              error.error());
  }
}

TEST(HiddenPixels, what_is_hidden_costs_nothing) {
  Mesh mesh = test::grid_mesh({.rows = 2, .columns = 4, .color_noise = 0.5}, 1);
  Frame frame = fit_frame(mesh, {}, 200);
  // The left half.
  frame.hidden =
      std::make_shared<HiddenPixels>(inside({{{0, 0}, {200, 0}, {200, 200}, {0, 200}}}), frame);
  EditError error = test::edit_error(mesh, mesh, frame, MetricKind::flip);
  Journal journal(mesh);
  merge(journal, test::between(mesh, Face{3}, Face{7}));
  EXPECT_EQ(error.after_edits(journal, 0), 0);
  journal.undo();
  merge(journal, test::between(mesh, Face{0}, Face{4}));
  EXPECT_GT(error.after_edits(journal, 0), 0);
}

}  // namespace
}  // namespace gradmesh
