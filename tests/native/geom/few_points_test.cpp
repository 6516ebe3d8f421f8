#include "geom/few_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

namespace gradmesh {
namespace {

double distance_to(const std::vector<glm::dvec2>& polygon, glm::dvec2 p) {
  double least = 1e300;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double length = glm::dot(b - a, b - a);
    const double t = length > 0 ? std::clamp(glm::dot(p - a, b - a) / length, 0.0, 1.0) : 0;
    least = std::min(least, glm::distance(p, a + t * (b - a)));
  }
  return least;
}

TEST(FewPoints, CornersStayAndWhatLiesOnSidesGoes) {
  std::vector<glm::dvec2> square;
  for (int k = 0; k < 8; ++k) square.push_back({k, 0});
  for (int k = 0; k < 8; ++k) square.push_back({8, k});
  for (int k = 0; k < 8; ++k) square.push_back({8 - k, 8});
  for (int k = 0; k < 8; ++k) square.push_back({0, 8 - k});
  EXPECT_EQ(with_few_points(square, 1e-9),
            (std::vector<glm::dvec2>{{0, 0}, {8, 0}, {8, 8}, {0, 8}}));
}

TEST(FewPoints, NoPointIsFartherThanTheTolerance) {
  std::mt19937 random(49);
  std::uniform_real_distribution<double> radius(0.5, 1.5);
  for (int run = 0; run < 50; ++run) {
    std::vector<glm::dvec2> polygon;
    for (int k = 0; k < 200; ++k) {
      const double angle = 2 * std::numbers::pi * k / 200;
      const double r = run % 2 == 0 ? radius(random) : 1;
      polygon.push_back(r * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    for (const double tolerance : {0.0, 0.01, 0.1}) {
      const std::vector<glm::dvec2> few = with_few_points(polygon, tolerance);
      EXPECT_LE(few.size(), polygon.size());
      for (const glm::dvec2 p : polygon) EXPECT_LE(distance_to(few, p), tolerance + 1e-12);
      if (run % 2 == 1 && tolerance > 0) {
        EXPECT_LT(few.size(), 40U) << "of a circle";
      }
    }
  }
}

TEST(FewPoints, PointsInOnePlaceAndFewOnesDoNoHarm) {
  EXPECT_TRUE(with_few_points({}, 1).empty());
  EXPECT_EQ(with_few_points({{0, 0}, {1, 0}, {0, 1}}, 9).size(), 3U);
  EXPECT_EQ(with_few_points(std::vector<glm::dvec2>(9, {2, 2}), 0).front(), glm::dvec2(2, 2));
}

}  // namespace
}  // namespace gradmesh
