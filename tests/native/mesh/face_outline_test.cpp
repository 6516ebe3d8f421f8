// Outlines of single faces and of sets of them (mesh/face_outline.h, mesh/boundary.h).
#include "mesh/face_outline.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "mesh/boundary.h"
#include "meshes.h"

namespace gradmesh {
namespace {

TEST(FaceOutline, keeps_to_the_sides) {
  const Mesh mesh = test::grid_mesh({.rows = 3, .columns = 3, .position_noise = 0.05}, 1);
  for (const Face face : mesh.faces()) {
    const FilledOutline outline = face_outline(mesh, face);
    const std::vector<glm::dvec2>& polygon = outline.outline.front();
    const Patch patch = mesh.patch(face);
    EXPECT_TRUE(contains(outline, patch.at(0.5, 0.5).position));
    const double size = glm::distance(patch.corner(0).position, patch.corner(2).position);
    for (const Halfedge side : mesh.sides(face)) {
      const glm::dvec2 on_side = mesh.side_of(side).at(0.37).position;
      double closest = size;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i], along = polygon[(i + 1) % polygon.size()] - a;
        const double t =
            glm::clamp(glm::dot(on_side - a, along) / glm::dot(along, along), 0.0, 1.0);
        closest = std::min(closest, glm::distance(on_side, a + t * along));
      }
      EXPECT_LT(closest, 2e-3 * size);
    }
  }
}

TEST(FaceOutline, of_a_face_with_straight_sides_has_four_points) {
  const Mesh mesh = test::grid_mesh({.rows = 2, .columns = 2}, 1);
  EXPECT_EQ(face_outline(mesh, *mesh.faces().begin()).outline.front().size(), 4u);
}

TEST(OuterSides, bound_a_set_of_faces) {
  const Mesh mesh = test::grid_mesh({.rows = 3, .columns = 3}, 1);
  EXPECT_EQ(outer_sides(mesh, {{4}}).size(), 4u);
  EXPECT_EQ(outer_sides(mesh, {{3}, {4}}).size(), 6u);
  EXPECT_EQ(outer_sides(mesh, {{0}, {4}}).size(), 8u) << "they meet in a point only";
  std::vector<Face> all;
  for (const Face face : mesh.faces()) all.push_back(face);
  EXPECT_EQ(outer_sides(mesh, all).size(), 12u);
  EXPECT_TRUE(outer_sides(mesh, {}).empty());
}

}  // namespace
}  // namespace gradmesh
