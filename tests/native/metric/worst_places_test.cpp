// The places of a picture where details have the largest errors (metric/worst_places.h).
#include "metric/worst_places.h"

#include <gtest/gtest.h>

namespace gradmesh {
namespace {

TEST(WorstPlaces, are_apart_and_in_order) {
  Plane errors(100, 80);
  Raster<std::uint8_t, 1> counts(100, 80, 1);
  const auto spot = [&](int x, int y, float error) {
    for (int v = y - 2; v < y + 2; ++v)
      for (int u = x - 2; u < x + 2; ++u) *errors.at(u, v) = error;
  };
  spot(20, 30, 0.25F);
  spot(24, 34, 0.5F);
  spot(70, 30, 0.75F);
  spot(50, 70, 1);
  *counts.at(50, 70) = 0;
  const std::vector<WorstPlace> worst = worst_places(errors, counts, 9);
  ASSERT_EQ(worst.size(), 3u);
  EXPECT_EQ(worst[0].place, glm::dvec2(50, 70));
  EXPECT_NEAR(worst[0].error, 15.0 / 16, 1e-6);
  EXPECT_EQ(worst[1].place, glm::dvec2(70, 30));
  EXPECT_EQ(worst[2].place, glm::dvec2(24, 34));
  EXPECT_EQ(worst_places(errors, counts, 1).size(), 1u);
  EXPECT_TRUE(worst_places(Plane(9, 9), Raster<std::uint8_t, 1>(9, 9, 1), 4).empty());
}

}  // namespace
}  // namespace gradmesh
