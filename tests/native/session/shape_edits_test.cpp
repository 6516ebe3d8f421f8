// Sides, points, handles and colours that a person sets by hand (session/shape_edits.h).
#include "session/shape_edits.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "form/blocks.h"
#include "form/handles.h"
#include "mesh/rectangle.h"
#include "mesh/validate.h"
#include "ops/color.h"
#include "sessions.h"

namespace gradmesh {
namespace {

using test::problem_for;
using test::view_of;

const glm::dvec2 center(100, 100);

Affine pixels_of(const Session& session) { return view_of(session).to_pixels; }

Pointed pointed_in(const Session& session, glm::dvec2 place) {
  return pointed_at(session.mesh(), pixels_of(session), place, 1000).value();
}

/// A grid of Coons patches whose sides are curves.
Mesh coons_mesh(unsigned seed) {
  std::mt19937 random(seed);
  MeshParts parts = test::grid_parts(
      {.rows = 5, .columns = 5, .position_noise = 0.1, .color_noise = 0.3}, random);
  for (Patch& patch : parts.patches) {
    patch = as_written(patch, 0);
    make_coons(patch);
  }
  return build_mesh(parts);
}

int straight_sides(const Mesh& mesh) {
  int count = 0;
  for (const Halfedge curve : mesh.curves())
    count += is_straight(mesh.curve_of(curve), rounding_of(mesh));
  return count;
}

TEST(ShapeEdits, a_side_becomes_straight_and_a_curve_again) {
  for (const MeshKind form : {MeshKind::one_gradient, MeshKind::blocks}) {
    Session session(problem_for(coons_mesh(1)));
    session.hands().set_form(form);
    const int handles = session.shown().now().counts().handles;
    session.hands().propose_straight(pointed_in(session, center));
    ASSERT_TRUE(session.hands().make());
    EXPECT_EQ(session.history().undo_name()->english(), "Make a side straight");
    EXPECT_EQ(straight_sides(session.mesh()), 1) << name(form);
    EXPECT_EQ(session.shown().now().counts().handles, handles - 2);
    const double error = session.shown().now().error;
    EXPECT_GT(error, 0);
    EXPECT_THROW(session.hands().propose_straight(pointed_in(session, center)), InputError);
    session.hands().propose_curve(pointed_in(session, center));
    ASSERT_TRUE(session.hands().make());
    EXPECT_EQ(session.shown().now().counts().handles, handles);
    EXPECT_LT(session.shown().now().error, error) << "the curve is fitted to the picture";
    EXPECT_THROW(session.hands().propose_curve(pointed_in(session, center)), InputError);
    EXPECT_EQ(validate(session.mesh()), std::vector<std::string>{});
  }
}

TEST(ShapeEdits, a_point_takes_its_handles_with_it) {
  Session session(problem_for(coons_mesh(2)));
  const Mesh before = session.mesh();
  const glm::dvec2 by(1, -2);
  const Point inner = before.origin(before.sides(pointed_in(session, center).face)[0]);
  const glm::dvec2 to = before.position(inner) + by;
  session.hands().propose_move({.point = inner}, to);
  ASSERT_TRUE(session.hands().make());
  const Mesh& after = session.mesh();
  EXPECT_EQ(after.position(inner), to);
  for (const Halfedge curve : after.curves())
    if (after.origin(curve) == inner) {
      EXPECT_EQ(after.curve_of(curve).m0, before.curve_of(curve).m0);
    }
  session.undo();
  EXPECT_EQ(session.mesh(), before);
  EXPECT_EQ(session.history().redo_name()->english(), "Move a point");
}

TEST(ShapeEdits, a_handle_goes_where_it_is_taken) {
  Session session(problem_for(coons_mesh(3)));
  const Mesh& mesh = session.mesh();
  const Halfedge curve = mesh.curve(pointed_in(session, center).edge);
  for (const bool is_at_end : {false, true}) {
    const Cubic<Value> c = mesh.curve_of(curve);
    const glm::dvec2 at = (is_at_end ? c.bezier2() : c.bezier1()).position;
    const auto grip = grip_at(mesh, pixels_of(session), pixels_of(session).point(at), 1);
    ASSERT_TRUE(grip && !grip->point.valid());
    EXPECT_EQ(grip->curve, curve);
    EXPECT_EQ(grip->is_at_end, is_at_end);
    const glm::dvec2 to = at + glm::dvec2(2, 1);
    session.hands().propose_move(*grip, to);
    ASSERT_TRUE(session.hands().make());
    const Cubic<Value> now = session.mesh().curve_of(curve);
    const glm::dvec2 there = (is_at_end ? now.bezier2() : now.bezier1()).position;
    EXPECT_LT(glm::distance(there, to), 1e-9);
  }
}

TEST(ShapeEdits, nothing_goes_where_no_error_is_measured) {
  Session session(problem_for(coons_mesh(4)));
  const Mesh before = session.mesh();
  const Point corner = before.origin(before.sides(*before.faces().begin())[0]);
  EXPECT_THROW(session.hands().propose_move({.point = corner}, glm::dvec2(-1e6)), InputError);
  EXPECT_THROW(session.hands().propose_move({.point = corner}, glm::dvec2(NAN)), InputError);
  EXPECT_FALSE(session.hands().make());
  EXPECT_EQ(session.mesh(), before);
  EXPECT_FALSE(grip_at(before, pixels_of(session), glm::dvec2(-500), 8));
}

TEST(ShapeEdits, colours_are_sharp_in_blocks_alone_and_can_be_joined) {
  Session session(problem_for(coons_mesh(5)));
  const glm::dvec3 red(1, 0, 0);
  EXPECT_THROW(session.hands().propose_color(pointed_in(session, center), red, true), InputError);
  session.hands().propose_color(pointed_in(session, center), red, false);
  ASSERT_TRUE(session.hands().make());
  const auto colors_there = [&] {
    const Mesh& mesh = session.mesh();
    std::vector<glm::dvec4> colors;
    for (const Halfedge corner : corners_at(mesh, mesh.origin(pointed_in(session, center).corner)))
      colors.push_back(mesh[corner].color);
    return colors;
  };
  EXPECT_EQ(colors_there(), std::vector(4, glm::dvec4(red, 1)));
  EXPECT_TRUE(find_grid(session.mesh()));
  session.hands().set_form(MeshKind::blocks);
  session.hands().propose_color(pointed_in(session, center), {0, 0, 1}, true);
  ASSERT_TRUE(session.hands().make());
  EXPECT_FALSE(has_one_color_at_each_point(session.mesh()));
  EXPECT_THROW(session.hands().set_form(MeshKind::one_gradient), InputError);
  session.hands().propose_joined(pointed_in(session, center));
  ASSERT_TRUE(session.hands().make());
  EXPECT_EQ(colors_there(), std::vector(4, glm::dvec4(0.75, 0, 0.25, 1)));
  EXPECT_THROW(session.hands().propose_joined(pointed_in(session, center)), InputError);
}

TEST(ShapeEdits, nothing_changes_what_is_protected) {
  Session session(problem_for(coons_mesh(6)));
  const Pointed pointed = pointed_in(session, center);
  session.protection().protect({pointed.face}, true);
  const Mesh before = session.mesh();
  EXPECT_THROW(session.hands().propose_straight(pointed), InputError);
  EXPECT_THROW(session.hands().propose_color(pointed, glm::dvec3(0), false), InputError);
  const Point corner = before.origin(pointed.corner);
  EXPECT_THROW(session.hands().propose_move({.point = corner}, before.position(corner) + 1.0),
               InputError);
  EXPECT_FALSE(session.hands().make());
  EXPECT_EQ(session.mesh(), before);
}

}  // namespace
}  // namespace gradmesh
