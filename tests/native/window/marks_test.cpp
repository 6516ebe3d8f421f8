// What a person marks, protects, weighs and colours in the window of simplifying by eye. No display
// is needed.
#include <gtest/gtest.h>

#include <algorithm>

#include "eye_windows.h"
#include "ops/color.h"

namespace gradmesh {
namespace {

using test::EyeWindows;
using test::ordinary_size;
using test::same;

TEST_F(EyeWindows, what_is_marked_and_protected_stays_whatever_the_slider_does) {
  open("ellipse");
  screen_->click("Mark");
  const Face face = *session().mesh().faces().begin();
  const Patch patch = session().mesh().patch(face);
  screen_->click(middle_of(face));
  EXPECT_EQ(eye_->marked(), std::vector{face});
  screen_->click("Protect");
  EXPECT_TRUE(session().mesh().is_fixed(face));
  wait_for_curve();
  screen_->key("End");
  const Mesh& mesh = session().mesh();
  const auto is_same = [&](Face each) {
    return mesh.is_fixed(each) &&
           mesh.patch(each).at(0.5, 0.5).position == patch.at(0.5, 0.5).position;
  };
  EXPECT_TRUE(std::ranges::any_of(mesh.faces(), is_same));
}

TEST_F(EyeWindows, a_drag_around_patches_marks_them_and_enter_makes_them_one) {
  open("ellipse");
  screen_->click("Blocks");
  screen_->key("K");
  // Around two patches side by side: from above the first to below the second.
  const Mesh& mesh = session().mesh();
  const Face first = *mesh.faces().begin();
  const Halfedge right = mesh.sides(first)[1];
  ASSERT_TRUE(mesh.other_side(right).valid());
  const Face second = mesh.face(mesh.other_side(right));
  const auto corner = [&](Face face, double u, double v) {
    return seen_at(mesh.patch(face).at(u, v).position);
  };
  const std::vector<Face> two = {std::min(first, second), std::max(first, second)};
  screen_->drag({corner(first, 0.1, 0.1), corner(first, 0.9, 0.9)});
  const std::size_t of_one = eye_->marked().size();
  EXPECT_GE(of_one, 1u);
  screen_->key("Escape");
  EXPECT_TRUE(eye_->marked().empty());
  for (const Face face : two) screen_->click(middle_of(face));
  EXPECT_EQ(eye_->marked(), two);
  ASSERT_TRUE(eye_->marks_price());
  const int patches = session().shown().now().counts().patches;
  screen_->key("Return");
  EXPECT_EQ(session().shown().now().counts().patches, patches - 1);
}

TEST_F(EyeWindows, the_brush_marks_what_it_touches) {
  open("ellipse");
  screen_->key("T");
  const Mesh& mesh = session().mesh();
  const Face first = *mesh.faces().begin();
  const Face second = mesh.face(mesh.other_side(mesh.sides(first)[1]));
  screen_->drag({middle_of(first), middle_of(second)});
  for (const Face face : {first, second})
    EXPECT_NE(std::ranges::find(eye_->marked(), face), eye_->marked().end());
}

TEST_F(EyeWindows, a_colour_is_chosen_for_a_point) {
  open("ellipse");
  const Mesh& mesh = session().mesh();
  const Point point = mesh.origin(mesh.sides(*mesh.faces().begin())[0]);
  eye_->element.point = point;
  screen_->settle();
  const auto green = [&] {
    const Mesh& now = session().mesh();
    return now[now[point].halfedge].color.g;
  };
  const double before = green();
  // What is chosen is seen before it is made.
  const glm::dvec2 at = *screen_->window().ui().place_of("value");
  screen_->move(at);
  screen_->hold(true);
  screen_->move(at - glm::dvec2(30, 0));
  screen_->settle();
  EXPECT_TRUE(session().hands().proposal());
  EXPECT_EQ(green(), before);
  screen_->hold(false);
  screen_->settle();
  EXPECT_LT(green(), before);
  EXPECT_EQ(session().history().undo_name()->english(), "Set the colour of a point");
  EXPECT_EQ(eye_->element.point, point) << "another colour can be chosen at once";
}

TEST_F(EyeWindows, a_colour_is_taken_from_the_picture) {
  open("ellipse");
  screen_->click("Look");
  const Mesh& mesh = session().mesh();
  const Face face = *mesh.faces().begin();
  eye_->element.point = mesh.origin(mesh.sides(face)[0]);
  screen_->key("L");
  const glm::dvec2 there(ordinary_size.x / 3, ordinary_size.y / 3);
  const std::uint32_t seen = screen_->pixel(int(there.x), int(there.y));
  ASSERT_TRUE(screen_->click("From the picture"));
  screen_->key("Escape");
  EXPECT_FALSE(eye_->picks_color);
  EXPECT_TRUE(screen_->is_open()) << "Escape lets go of the eyedropper alone";
  ASSERT_TRUE(screen_->click("From the picture"));
  screen_->click(there);
  EXPECT_FALSE(eye_->picks_color);
  const Mesh& now = session().mesh();
  const glm::dvec4 color = now[corners_at(now, eye_->element.point).front()].color;
  for (const int channel : {0, 1, 2})
    EXPECT_NEAR(255 * color[channel], seen >> (16 - 8 * channel) & 255, 0.5);
}

TEST_F(EyeWindows, weights_are_read_back_and_taken_away) {
  open("ellipse");
  const Face face = *session().mesh().faces().begin();
  EXPECT_FALSE(screen_->window().ui().place_of("Errors count alike everywhere"));
  eye_->mark({face}, false);
  screen_->settle();
  ASSERT_TRUE(screen_->click("weight 4"));
  EXPECT_EQ(session().shown().weight_at(face), 4);
  ASSERT_TRUE(screen_->click("Errors count alike everywhere"));
  EXPECT_EQ(session().shown().weight_at(face), 1);
  screen_->key("Z", {.control = true});
  EXPECT_EQ(session().shown().weight_at(face), 4);
}

TEST_F(EyeWindows, what_a_drag_would_mark_is_seen_while_it_goes_on) {
  open("ellipse");
  screen_->key("K");
  const glm::dvec2 middle = eye_->viewport().size() / 2.0;
  screen_->move(middle);
  screen_->hold(true);
  for (const double share : {0.1, 0.3}) screen_->move(middle * (1 + share));
  const auto dragging = pixels();
  screen_->hold(false);
  const std::vector<Face> marked = eye_->marked();
  ASSERT_FALSE(marked.empty());
  // On the side of a marked patch away from the rectangle's own lines, the ink of what is picked.
  int picked = 0;
  for (const std::uint32_t pixel : dragging) picked += pixel == 0xffc800;
  EXPECT_GT(picked, 100);
}

}  // namespace
}  // namespace gradmesh
