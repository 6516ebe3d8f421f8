// Which patches a person means by a drag (session/pointing.h).
#include "session/pointing.h"

#include <gtest/gtest.h>

#include "geom/box.h"
#include "mesh/boundary.h"
#include "sessions.h"

namespace gradmesh {
namespace {

using test::mesh_for;
using test::problem_for;
using test::view_of;

std::vector<glm::dvec2> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

TEST(Pointing, patches_in_a_lasso_are_those_of_which_a_third_is_inside) {
  // A grid of five by five patches of 36 pixels, from 10 on.
  Session session(problem_for(test::grid_mesh({.rows = 5, .columns = 5, .color_noise = 0.05}, 1)));
  const Mesh& mesh = session.mesh();
  const Affine to_pixels = view_of(session).to_pixels;
  const auto box = bounding_box(mesh, to_pixels);
  const double side = box.size().x / 5, left = box.low().x;
  const auto up_to = [&](double columns) {
    return faces_covered(mesh, to_pixels, rectangle(-50, -50, left + columns * side, 300)).size();
  };
  EXPECT_EQ(up_to(5), 25u);
  EXPECT_EQ(up_to(2.2), 10u);
  EXPECT_EQ(up_to(2.45), 15u);
  EXPECT_EQ(up_to(0.2), 1u) << "the one that is covered most, where none is covered by a third";
  EXPECT_EQ(up_to(-0.2), 0u);
}

TEST(Pointing, patches_on_a_line_are_those_that_it_touches) {
  Session session(problem_for(test::grid_mesh({.rows = 5, .columns = 5, .color_noise = 0.05}, 1)));
  const Mesh& mesh = session.mesh();
  const Affine to_pixels = view_of(session).to_pixels;
  const auto box = bounding_box(mesh, to_pixels);
  const auto touched = [&](glm::dvec2 from, glm::dvec2 to) {
    const auto place = [&](glm::dvec2 p) { return box.low() + p * box.size() / 5.0; };
    return faces_touched(mesh, to_pixels, {place(from), place(to)}).size();
  };
  EXPECT_EQ(touched({0.5, 0.5}, {0.5, 0.5}), 1u);
  EXPECT_EQ(touched({-1, 0.5}, {6, 0.5}), 5u);
  EXPECT_EQ(touched({0.4, 0.5}, {0.5, 4.6}), 5u);
  EXPECT_EQ(touched({-1, -1}, {6, -1}), 0u);
  EXPECT_TRUE(faces_touched(mesh, to_pixels, {}).empty());
}

TEST(Pointing, patches_in_a_lasso_can_be_merged) {
  Session session(problem_for(mesh_for(1)));
  const Affine to_pixels = view_of(session).to_pixels;
  const Box box = bounding_box(session.mesh(), to_pixels);
  const glm::dvec2 low = box.low() + 0.2 * box.size(), high = box.low() + 0.6 * box.size();
  session.hands().propose_merge(
      faces_covered(session.mesh(), to_pixels, rectangle(low.x, low.y, high.x, high.y)));
  EXPECT_EQ(session.hands().proposal()->written.surface().face_count(), 22);
  EXPECT_EQ(session.mesh().face_count(), 25) << "it is only shown";
  session.hands().make();
  EXPECT_EQ(session.history().undo_name()->english(), "Merge 4 patches");
  EXPECT_EQ(session.mesh().face_count(), 22);
  EXPECT_EQ(session.shown().form(), MeshKind::blocks);
}

}  // namespace
}  // namespace gradmesh
