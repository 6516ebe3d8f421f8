#include <gtest/gtest.h>

#include <map>

#include "mesh/dependence.h"
#include "ops/refresh.h"
#include "ops/straighten.h"
#include "problems.h"
#include "random_meshes.h"
#include "raster/folds.h"
#include "raster/hidden.h"
#include "same_mesh.h"
#include "trial/fit_trial.h"

/// Fits: the mesh is linear in what they may change, and they come closer to the picture.
namespace gradmesh {
namespace {

Mesh junction_mesh(ColorModel model, unsigned seed) {
  std::mt19937 random(seed);
  const MeshParts parts = test::grid_parts(
      {.rows = 4, .columns = 4, .position_noise = 0.08, .color_noise = 0.1, .color_model = model},
      random);
  return test::changed_mesh(parts, seed, 8);
}

std::vector<Face> faces_of(const Mesh& mesh) {
  std::vector<Face> faces;
  for (const Face f : mesh.faces()) faces.push_back(f);
  return faces;
}

Value random_value(const Unknown& unknown, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  Value v;
  v.position = 20.0 * glm::dvec2(unit(random), unit(random));
  if (unknown.moves_color) v.color = 0.1 * glm::dvec4(unit(random), unit(random), unit(random), 0);
  return v;
}

/// Returns the patch of a face as the influences say that it becomes.
Patch moved(const Mesh& before, const InfluencedFace& face, const std::vector<Value>& by) {
  Patch patch = before.patch(face.face);
  for (const Influence& influence : face.by)
    for (std::size_t k = 0; k < 16; ++k) {
      const Value& v = by[std::size_t(influence.unknown)];
      patch.c[k / 4][k % 4] += Value{v.position * influence.place[k], v.color * influence.color[k]};
    }
  return patch;
}

/// Puts the first two handles of each point in one line, but makes every third curve straight and
/// every other face a Coons patch.
void make_some_plain(Journal& journal) {
  const Mesh& mesh = journal.mesh();
  std::map<Point, std::vector<Handle>> handles;
  journal.begin();
  std::vector<Halfedge> curves;
  for (const Halfedge h : mesh.halfedges())
    if (!mesh.is_bar(h) && mesh.curve(h) == h) curves.push_back(h);
  for (const Halfedge h : in_order_of_dependence(mesh, curves)) {
    if (h.value % 3 == 0) {
      straighten(journal, h);
    } else {
      handles[mesh.origin(h)].push_back(mesh[h].handles[0]);
      handles[mesh.end(h)].push_back(mesh[h].handles[1]);
    }
    refresh_curve(journal, h);
  }
  for (const auto& [point, here] : handles)
    if (here.size() > 1 && !mesh[point].is_junction())
      journal.edit(here[1]).tangent.position = -1.5 * mesh[here[0]].tangent.position;
  // Straight curves that end on those that have changed have to follow.
  for (const Halfedge h : in_order_of_dependence(mesh, curves)) {
    if (h.value % 3 == 0) straighten(journal, h);
    refresh_curve(journal, h);
  }
  for (const Face f : mesh.faces())
    if (f.value % 2 == 0) drop_tensor(journal, f);
}

TEST(Fit, patches_are_linear_in_the_unknowns) {
  for (const ColorModel model : {ColorModel::bilinear, ColorModel::bicubic})
    for (unsigned seed = 0; seed < 8; ++seed) {
      Mesh mesh = junction_mesh(model, seed);
      const Mesh before = mesh;
      Journal journal(mesh);
      const auto unknowns = unknowns_of(mesh, faces_of(mesh));
      const auto influenced = influences(journal, unknowns);
      EXPECT_TRUE(test::same(mesh, before));

      std::mt19937 random(seed);
      std::vector<Value> by;
      for (const Unknown& unknown : unknowns) by.push_back(random_value(unknown, random));
      journal.begin();
      change(journal, unknowns, by);
      EXPECT_EQ(influenced.size(), std::size_t(mesh.face_count()));
      for (const InfluencedFace& face : influenced)
        EXPECT_LT(test::difference(mesh.patch(face.face), moved(before, face, by)), 1e-9)
            << "seed " << seed;
    }
}

/// Sides that are straight, Coons patches and handles in one line stay so, and the mesh stays
/// linear in what is left: points and the rest.
TEST(Fit, leaves_plain_what_is_plain) {
  int places = 0, in_line = 0;
  for (unsigned seed = 0; seed < 8; ++seed) {
    Mesh mesh = junction_mesh(ColorModel::bilinear, seed);
    Journal journal(mesh);
    make_some_plain(journal);
    const Mesh before = mesh;
    const Plainness plain(before);
    const auto unknowns = unknowns_of(mesh, faces_of(mesh), plain);
    const auto influenced = influences(journal, unknowns, plain);
    EXPECT_TRUE(test::same(mesh, before));
    for (const Unknown& unknown : unknowns) places += unknown.kind == Unknown::place;

    std::mt19937 random(seed);
    std::vector<Value> by;
    for (const Unknown& unknown : unknowns) by.push_back(random_value(unknown, random));
    journal.begin();
    change(journal, unknowns, by, plain);
    for (const InfluencedFace& face : influenced)
      EXPECT_LT(test::difference(mesh.patch(face.face), moved(before, face, by)), 1e-9);
    const Plainness after(mesh);
    for (const Face f : mesh.faces()) EXPECT_LE(plain.is_coons(f), after.is_coons(f));
    for (const Halfedge h : mesh.halfedges()) {
      if (mesh.is_bar(h) || mesh.curve(h) != h) continue;
      EXPECT_EQ(plain.is_straight(h), after.is_straight(h));
      for (const Handle handle : mesh[h].handles) {
        const auto opposite = plain.opposite(handle);
        in_line += opposite.has_value();
        EXPECT_TRUE(!opposite || after.opposite(handle)) << "seed " << seed;
      }
    }
  }
  EXPECT_GT(places, 10);
  EXPECT_GT(in_line, 10);
}

TEST(Fit, unknowns_of_a_face_change_it_and_those_beside_it) {
  Mesh mesh = test::grid_mesh({.rows = 5, .columns = 5});
  Journal journal(mesh);
  std::vector<Face> seen;
  for (const auto& face : influences(journal, unknowns_of(mesh, {Face{12}})))
    seen.push_back(face.face);
  EXPECT_EQ(seen, (std::vector{Face{7}, Face{11}, Face{12}, Face{13}, Face{17}}));
}

/// Moves the unknowns of one face at random, and fits it: most of the difference goes.
TEST(Fit, finds_back_what_was_moved) {
  for (const ColorModel model : {ColorModel::bilinear, ColorModel::bicubic})
    for (unsigned seed = 0; seed < 6; ++seed) {
      Mesh mesh = test::grid_mesh({.rows = 3,
                                   .columns = 3,
                                   .position_noise = 0.05,
                                   .color_noise = 0.2,
                                   .color_model = model},
                                  seed);
      const Mesh original = mesh;
      const Frame frame = fit_frame(original, {}, 200);
      std::mt19937 random(seed);
      {
        Journal journal(mesh);
        journal.begin();
        const auto unknowns = unknowns_of(mesh, {Face{4}});
        std::vector<Value> by;
        for (const Unknown& unknown : unknowns) by.push_back(random_value(unknown, random));
        change(journal, unknowns, by);
      }
      FitTrial trial(mesh, test::edit_error(original, mesh, frame, MetricKind::flip));
      const double before = trial.error();
      trial.improve({Face{4}}, 8);
      EXPECT_LT(trial.error(), 0.5 * before) << "seed " << seed;
      EXPECT_NEAR(
          trial.error(),
          test::edit_error(original, original, frame, MetricKind::flip).whole_frame(mesh).mean,
          1e-9);
    }
}

/// What nobody sees asks for nothing: the rim of a mesh is hidden, so that a patch at its border is
/// fitted to what is seen of it alone, whatever its border looked like.
TEST(Fit, is_not_held_by_what_is_hidden) {
  const Mesh original = test::grid_mesh({.rows = 3, .columns = 3, .color_noise = 0.2}, 1);
  Frame frame = fit_frame(original, {}, 200);
  const Window border = pixel_bounds(original.patch(Face{0}), frame)
                            .united(pixel_bounds(original.patch(Face{8}), frame));
  constexpr double rim = 6;
  const double left = border.x0 + rim, right = border.x1 - rim;
  const double top = border.y0 + rim, bottom = border.y1 - rim;
  const VisibleArea seen{
      {{{{{{left, top}, {right, top}, {right, bottom}, {left, bottom}}}, FillRule::nonzero}}}};
  // The outline of the area is in pixels here.
  Frame pixels = frame;
  pixels.to_pixels = {};
  frame.hidden = std::make_shared<HiddenPixels>(seen, pixels);

  const auto target = test::reference(original, frame);
  const glm::dvec2 hidden(border.x0 + rim / 2, (top + bottom) / 2);
  EXPECT_FALSE(target->color_at(hidden));
  EXPECT_TRUE(target->is_hidden(hidden));

  // The border goes outwards, where nobody sees it, and the colours with it.
  Mesh mesh = original;
  Journal journal(mesh);
  journal.begin();
  const auto unknowns = unknowns_of(mesh, {Face{3}});
  Value by;
  by.position = {-8, 0};
  change(journal, unknowns, std::vector(unknowns.size(), by));
  const Mesh moved = mesh;
  FitTrial trial(mesh, EditError(target, mesh));
  const double before = trial.error();
  trial.improve({Face{3}}, 8);
  EXPECT_LT(trial.error(), 0.25 * before);
}

TEST(FitTrial, prices_and_refused_merges_leave_everything_as_it_was) {
  for (const ColorModel model : {ColorModel::bilinear, ColorModel::bicubic})
    for (unsigned seed = 0; seed < 4; ++seed) {
      Mesh mesh = junction_mesh(model, seed);
      const Mesh before = mesh;
      const Frame frame = fit_frame(mesh, {}, 150);
      FitTrial trial(mesh, test::edit_error(before, mesh, frame, MetricKind::ssim));
      int priced = 0;
      for (const Halfedge h : before.halfedges()) {
        if (!before.is_leaf(h) || !leaf_across(before, h).valid()) continue;
        const Region region = region_of_edge(before, h);
        const double price = trial.price(region, 1);
        priced += std::isfinite(price);
        EXPECT_TRUE(test::same(mesh, before));
        EXPECT_FALSE(trial.try_and_fit({region}, -1, 3));
        EXPECT_TRUE(test::same(mesh, before));
        EXPECT_EQ(trial.error(), 0);
      }
      EXPECT_GT(priced, 4);
    }
}

/// What Eq. 5 makes of two patches strays further from them than a fit.
TEST(FitTrial, no_patch_folds_that_did_not) {
  int unfolded = 0;
  for (unsigned seed = 0; seed < 8; ++seed) {
    Mesh mesh = junction_mesh(ColorModel::bicubic, seed);
    const Frame frame = fit_frame(mesh, {}, 100);
    // The picture of another mesh, so that fits have every reason to move.
    const Mesh other = junction_mesh(ColorModel::bicubic, seed + 100);
    std::vector<Face> before;
    for (const Face f : faces_of(mesh))
      if (!may_fold(mesh.patch(f))) before.push_back(f);
    FitTrial trial(mesh, test::edit_error(other, mesh, frame, MetricKind::ssim));
    const double error = trial.error();
    trial.improve(faces_of(mesh), 8);
    EXPECT_LT(trial.error(), error);
    for (const Face f : before) EXPECT_FALSE(may_fold(mesh.patch(f)));
    unfolded += int(before.size());
  }
  EXPECT_GT(unfolded, 20);
}

TEST(FitTrial, fitted_merges_cost_less) {
  double merged = 0, fitted = 0;
  for (unsigned seed = 0; seed < 6; ++seed) {
    Mesh mesh = junction_mesh(ColorModel::bicubic, seed);
    const Mesh original = mesh;
    const Frame frame = fit_frame(mesh, {}, 150);
    const EditError error = test::edit_error(original, mesh, frame, MetricKind::flip);
    for (const Halfedge h : original.halfedges()) {
      if (!original.is_leaf(h) || !leaf_across(original, h).valid()) continue;
      Mesh copy = original;
      FitTrial trial(copy, test::edit_error(original, copy, frame, MetricKind::flip));
      const Region region = region_of_edge(original, h);
      const double price = trial.price(region, 1);
      if (!trial.try_and_fit({region}, 1, 0)) continue;
      EXPECT_LE(price, trial.error() + 1e-12);
      merged += trial.error();
      fitted += price;
      const double before = trial.error();
      trial.improve(faces_of(copy), 3);
      EXPECT_LE(trial.error(), before);
      EXPECT_NEAR(trial.error(), error.whole_frame(copy).mean, 1e-9);
    }
  }
  EXPECT_LT(fitted, 0.6 * merged);
}

}  // namespace
}  // namespace gradmesh
