#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "mesh/color_model.h"
#include "mesh/subdivide.h"
#include "mesh/validate.h"
#include "meshes.h"
#include "random_meshes.h"
#include "raster/rasterizer.h"
#include "same_mesh.h"

namespace gradmesh {
namespace {

using test::difference;
using test::junctions;

/// A random mesh with T-junctions.
Mesh random_mesh(unsigned seed, ColorModel model) {
  const MeshParts parts = test::grid_parts(
      {.rows = 3, .columns = 3, .position_noise = 0.1, .color_noise = 0.2, .color_model = model},
      seed);
  return test::changed_mesh(parts, seed, int(seed % 40), 2);
}

/// Whether some T-junction of a `bicubic` mesh has colours of its own, between whose corners the
/// new patches cannot have all of the old colours.
bool has_own_colors(const Mesh& mesh) {
  return mesh.color_model() == ColorModel::bicubic &&
         std::ranges::any_of(mesh.halfedges(), [&](Halfedge h) {
           return mesh.is_leaf(h) && mesh[mesh.origin(h)].is_junction() && mesh[h].own_color;
         });
}

/// The patch with all of its geometry, and its colours at the corners alone.
Patch corner_colors(Patch patch) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (i % 3 != 0 || j % 3 != 0) patch.c[i][j].color = glm::dvec4(0);
  return patch;
}

/// Share of the samples that differ by more than one level.
double share_of_different_samples(const Mesh& a, const Mesh& b) {
  const Frame frame = fit_frame(a, Affine{}, 200);
  const auto rasterizer = make_software_rasterizer();
  const Image first = rasterizer->paint(a, frame), second = rasterizer->paint(b, frame);
  std::size_t different = 0;
  for (std::size_t i = 0; i < first.samples.size(); ++i)
    different += std::abs(int(first.samples[i]) - int(second.samples[i])) > 1;
  return double(different) / double(first.samples.size());
}

TEST(Subdivided, patches_are_the_parts_of_the_old_ones) {
  std::size_t with_junctions = 0, exact = 0;
  for (const ColorModel model : {ColorModel::bilinear, ColorModel::bicubic})
    for (unsigned seed = 0; seed < 60; ++seed) {
      const Mesh mesh = random_mesh(seed, model);
      const int n = 1 + int(seed % 4);
      const MeshParts parts = subdivided(mesh, n);
      const Mesh fine = build_mesh(parts);
      ASSERT_EQ(validate(fine), std::vector<std::string>{}) << "seed " << seed;
      ASSERT_EQ(fine.face_count(), n * n * mesh.face_count());
      int next = 0;
      for (const Face f : mesh.faces())
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j) {
            const Patch part = mesh.patch(f)
                                   .part_u(double(i) / n, double(i + 1) / n)
                                   .part_v(double(j) / n, double(j + 1) / n);
            const Patch found = fine.patch(Face{next++});
            ASSERT_LE(difference(corner_colors(found), corner_colors(part)), 1e-9) << seed;
            if (!has_own_colors(mesh)) {
              ASSERT_LE(difference(found, part), 1e-9) << seed;
            }
          }
      with_junctions += junctions(fine);
      exact += !has_own_colors(mesh);
    }
  EXPECT_GT(with_junctions, 1000u);
  EXPECT_GE(exact, 60u);
}

TEST(Subdivided, a_grid_stays_a_grid) {
  for (const int n : {1, 2, 3, 7}) {
    const Mesh mesh = test::grid_mesh({.rows = 3, .columns = 2, .position_noise = 0.1});
    const Mesh fine = build_mesh(subdivided(mesh, n));
    EXPECT_EQ(junctions(fine), 0u);
    EXPECT_EQ(std::ranges::distance(fine.points()), (3 * n + 1) * (2 * n + 1));
    EXPECT_EQ(std::ranges::distance(fine.halfedges()), 4 * 6 * n * n);
  }
}

TEST(Subdivided, curves_are_cut_where_both_sides_are_divided) {
  // A row of one patch above a row of three: the T-junctions at thirds go where n is 3, and where
  // n is 2 the middle of the long side meets the middle of the bar in the middle.
  Mesh mesh = test::grid_mesh({.rows = 2, .columns = 1, .position_noise = 0.1});
  Journal journal(mesh);
  const Halfedge top = mesh.sides(Face{1})[0];
  split(journal, top, 1.0 / 3);
  split(journal, mesh.sides(Face{2})[0], 0.5);
  ASSERT_EQ(junctions(mesh), 2u);
  EXPECT_EQ(junctions(build_mesh(subdivided(mesh, 1))), 2u);
  EXPECT_EQ(junctions(build_mesh(subdivided(mesh, 3))), 6u);
  EXPECT_EQ(junctions(build_mesh(subdivided(mesh, 2))), 4u);
}

TEST(Subdivided, a_sliver_at_the_end_of_a_curve_is_no_curve_of_its_own) {
  for (const double at : {4e-10, 1 - 4e-10}) {
    Mesh mesh = test::grid_mesh({.rows = 2, .columns = 1});
    Journal journal(mesh);
    split(journal, mesh.sides(Face{1})[0], at);
    for (const int n : {1, 2}) {
      const Mesh fine = build_mesh(subdivided(mesh, n));
      EXPECT_EQ(validate(fine), std::vector<std::string>{});
      EXPECT_EQ(fine.face_count(), 3 * n * n);
      int outside = 0;
      for (const Halfedge h : fine.halfedges())
        outside += fine.is_leaf(h) && !fine.other_side(h).valid();
      EXPECT_EQ(outside, 7 * n);
    }
  }
}

TEST(Subdivided, junctions_keep_their_own_colours) {
  Mesh mesh = test::grid_mesh({.rows = 2, .columns = 1, .color_model = ColorModel::bicubic});
  Journal journal(mesh);
  split(journal, mesh.sides(Face{1})[0], 0.3);
  MeshParts parts = subdivided(mesh, 1);
  parts.patches[1].c[0][3].color.r += 0.4;
  const Mesh sharp = build_mesh(parts);
  const Mesh fine = build_mesh(subdivided(sharp, 3));
  int next = 0;
  for (const Face f : sharp.faces())
    for (int i = 0; i < 9; ++i) {
      const Patch part = sharp.patch(f)
                             .part_u((i / 3) / 3.0, (i / 3 + 1) / 3.0)
                             .part_v((i % 3) / 3.0, (i % 3 + 1) / 3.0);
      const Patch found = fine.patch(Face{next++});
      for (int k = 0; k < 4; ++k)
        EXPECT_LE(glm::length(found.corner(k).color - part.corner(k).color), 1e-12);
    }
  EXPECT_EQ(build_mesh(subdivided(sharp, 1)).patch(Face{1}), sharp.patch(Face{1}));
}

TEST(Subdivided, paints_the_same) {
  for (const ColorModel model : {ColorModel::bilinear, ColorModel::bicubic})
    for (unsigned seed = 0; seed < 12; ++seed) {
      const Mesh mesh = random_mesh(3 * seed, model);
      if (has_own_colors(mesh)) continue;
      const Mesh fine = build_mesh(subdivided(mesh, 2 + int(seed % 3)));
      // Triangles are within a tenth of a pixel of the surface, but those of the two meshes are not
      // the same: a few pixels at the silhouette and along curves change hands.
      EXPECT_LE(share_of_different_samples(mesh, fine), 0.0005) << "seed " << seed;
    }
}

TEST(ColorModel, bicubic_paints_what_bilinear_does) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    const Mesh mesh = random_mesh(seed, ColorModel::bilinear);
    const Mesh bicubic = build_mesh(as_bicubic(subdivided(mesh, 1)));
    EXPECT_EQ(bicubic.color_model(), ColorModel::bicubic);
    ASSERT_EQ(validate(bicubic), std::vector<std::string>{});
    int next = 0;
    for (const Face f : mesh.faces())
      EXPECT_LE(difference(bicubic.patch(Face{next++}), mesh.patch(f)), 1e-9) << "seed " << seed;
  }
}

TEST(ColorModel, bilinear_keeps_corners_within_range) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    MeshParts parts = subdivided(random_mesh(seed, ColorModel::bicubic), 1);
    parts.patches[0].c[0][0].color.r = 1.3;
    parts.patches[0].c[0][3].color.g = -0.2;
    const Mesh mesh = build_mesh(parts);
    const Mesh bilinear = build_mesh(as_bilinear(parts));
    EXPECT_EQ(bilinear.color_model(), ColorModel::bilinear);
    ASSERT_EQ(validate(bilinear), std::vector<std::string>{});
    for (const Face f : mesh.faces())
      for (int k = 0; k < 4; ++k) {
        const Value is = bilinear.patch(f).corner(k), was = mesh.patch(f).corner(k);
        EXPECT_EQ(is.position, was.position);
        for (int channel = 0; channel < 4; ++channel)
          EXPECT_NEAR(is.color[channel], std::clamp(was.color[channel], 0.0, 1.0), 0.51 / 255);
      }
  }
}

/// What lies between the corners shrinks with the square of the patches' size.
TEST(ColorModel, bilinear_comes_close_with_small_patches) {
  const Mesh mesh = random_mesh(20, ColorModel::bicubic);
  double before = 0;
  for (const int n : {2, 4, 8, 16}) {
    const MeshParts exact = subdivided(mesh, n), bilinear = as_bilinear(exact);
    double most = 0;
    for (std::size_t p = 0; p < exact.patches.size(); ++p)
      for (const double u : {0.25, 0.5, 0.75})
        for (const double v : {0.25, 0.5, 0.75})
          most = std::max(most, glm::length(exact.patches[p].at(u, v).color -
                                            bilinear.patches[p].at(u, v).color));
    EXPECT_GT(most, 1e-4);
    if (n > 2) {
      EXPECT_LE(most, 0.35 * before) << n;
    }
    before = most;
  }
}

}  // namespace
}  // namespace gradmesh
