// From where a person looks at a page (window/eye/viewport.h).
#include "window/eye/viewport.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace gradmesh {
namespace {

Box subject() {
  Box box;
  box.add({10, 20});
  box.add({110, 70});
  return box;
}

void expect_near(glm::dvec2 a, glm::dvec2 b) { EXPECT_LT(glm::distance(a, b), 1e-9); }

TEST(Viewport, shows_all_of_its_subject_until_a_person_looks_closer) {
  Viewport view(subject());
  for (const glm::dvec2 size : {glm::dvec2(400, 300), {200, 800}}) {
    view.resize(size);
    for (const glm::dvec2 corner : {glm::dvec2(10, 20), {110, 70}}) {
      const glm::dvec2 seen = view.to_pixels().point(corner);
      EXPECT_TRUE(seen.x > 0 && seen.y > 0 && seen.x < size.x && seen.y < size.y);
    }
    expect_near(view.place_at(size / 2.0), {60, 45});
  }
  const double scale = view.scale();
  view.zoom(4);
  view.resize({1000, 1000});
  EXPECT_DOUBLE_EQ(view.scale(), 4 * scale);
}

TEST(Viewport, the_place_below_the_pointer_stays_there) {
  Viewport view(subject());
  view.resize({400, 300});
  const glm::dvec2 pixel(37, 211), place = view.place_at(pixel);
  view.zoom(3.5, pixel);
  expect_near(view.place_at(pixel), place);
  view.zoom(0.1, pixel);
  expect_near(view.place_at(pixel), place);
  view.pan({-20, 8});
  expect_near(view.place_at(pixel + glm::dvec2(-20, 8)), place);
  expect_near(view.to_pixels().point(place), pixel + glm::dvec2(-20, 8));
}

TEST(Viewport, no_step_leads_to_where_nothing_is_seen) {
  Viewport view(subject());
  view.resize({400, 300});
  for (int i = 0; i < 200; ++i) view.zoom(0.5);
  EXPECT_GE(100 * view.scale(), 7.9);
  for (int i = 0; i < 200; ++i) view.zoom(2);
  EXPECT_LE(view.scale(), 1e4);
}

TEST(Viewport, a_place_that_is_looked_at_is_in_the_middle_and_large) {
  Viewport view(subject());
  view.resize({400, 300});
  view.look_at({100, 30});
  expect_near(view.place_at({200, 150}), {100, 30});
  EXPECT_GE(100 * view.scale(), 3 * 300);
  // Nobody who is closer already is taken away from there.
  view.zoom(10);
  const double scale = view.scale();
  view.look_at({20, 30});
  EXPECT_DOUBLE_EQ(view.scale(), scale);
}

TEST(Viewport, a_subject_without_size_is_looked_at_too) {
  Box point;
  point.add({5, 5});
  Viewport view(point);
  view.resize({400, 300});
  expect_near(view.to_pixels().point({5, 5}), {200, 150});
}

}  // namespace
}  // namespace gradmesh
