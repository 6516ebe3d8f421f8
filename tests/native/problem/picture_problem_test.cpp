// Runs and sessions that are measured against a picture instead of a mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "app/document/document.h"
#include "app/pages/read_document.h"
#include "mesh/validate.h"
#include "originals.h"
#include "sessions.h"

namespace gradmesh {
namespace {

using test::mesh_for;
using test::picture_by;

constexpr int resolution = 120;

Mesh sample(const std::string& name) {
  const auto document = read_document(GRADMESH_SOURCE_DIR "/samples/" + name + ".svg");
  return document->mesh(document->meshes().front());
}

/// The options of a run against what the mesh paints in the frame of a run against itself. The
/// picture is not padded once more, so that the frames are the same.
RunOptions against_picture_by(const Mesh& mesh) {
  RunOptions options;
  options.resolution = resolution;
  options.padding = {.share = 0, .length = 0};
  options.original = picture_by(mesh, fit_frame(mesh, {}, resolution));
  return options;
}

/// A sample and a method.
using Case = std::pair<std::string, std::string>;

class PictureRuns : public testing::TestWithParam<Case> {};

TEST_P(PictureRuns, keep_the_bound_against_a_picture) {
  const auto& [name, method] = GetParam();
  const Mesh mesh = sample(name);
  RunOptions options = against_picture_by(mesh);
  options.method = method;
  options.epsilon = 0.01;
  const Problem problem = test::problem(mesh, options);
  EXPECT_EQ(problem.unchanged().error, 0);

  Mesh simplified = mesh;
  const SimplifyResult result = simplify(simplified, options);
  EXPECT_TRUE(result.changed);
  EXPECT_LE(result.error, options.epsilon);
  EXPECT_LT(result.patches_after, result.patches_before);
  EXPECT_EQ(validate(result.mesh), std::vector<std::string>());
  // The picture is what the mesh paints, so that another measures the same.
  const Reference of_mesh(mesh, problem.frame(), problem.metric());
  const MeasuredSurface measured(of_mesh, result.surface(), result.form.masks_opacity(), nullptr);
  EXPECT_DOUBLE_EQ(measured.error().mean, result.error);
}

INSTANTIATE_TEST_SUITE_P(Samples, PictureRuns,
                         testing::Values(Case{"ellipse", "plain"}, Case{"ellipse", "best"},
                                         Case{"face", "best"}),
                         [](const auto& chosen) {
                           return chosen.param.first + "_" + chosen.param.second;
                         });

TEST(PictureProblem, is_about_the_picture_and_not_about_the_mesh) {
  const Mesh painted = mesh_for(1), mesh = mesh_for(2);
  const Problem problem = test::problem(mesh, against_picture_by(painted));
  EXPECT_FALSE(problem.original()->mesh());
  const double error = problem.unchanged().error;
  EXPECT_GT(error, 0);
  EXPECT_DOUBLE_EQ(problem.measure(mesh).error, error);
  EXPECT_EQ(problem.measure(painted).error, 0);
  EXPECT_DOUBLE_EQ(problem.with_mesh(std::make_shared<const Mesh>(painted)).unchanged().error, 0);
  EXPECT_FALSE(problem.price_key() == test::problem(mesh, {}).price_key());
}

TEST(PictureProblem, has_a_picture_with_half_as_many_pixels) {
  const Mesh mesh = mesh_for(3);
  const Problem problem = test::problem(mesh, against_picture_by(mesh));
  const Reference& coarse = problem.coarse_reference();
  EXPECT_EQ(coarse.frame().width, problem.frame().width / 2);
  EXPECT_EQ(coarse.painting().image, problem.original()->painted(coarse.frame()).image);
}

TEST(PictureProblem, bounds_a_translucent_picture_on_black_too) {
  const Mesh mesh = mesh_for(4);
  const Frame frame = fit_frame(mesh, {}, resolution);
  RgbaImage picture = test::with_opacities(paint_whole(mesh, frame).image);
  std::fill(picture.samples.end() - std::ptrdiff_t(picture.pixels()), picture.samples.end(), 100);
  RunOptions options = against_picture_by(mesh);
  options.original = original_of(std::move(picture), frame.to_pixels.inverse());
  const Problem problem = test::problem(mesh, options);
  EXPECT_TRUE(problem.reference()->metric_on_black());
  // The opaque mesh is lighter than the picture on black, and darker on white.
  EXPECT_GT(problem.unchanged().error, 0.1);
}

TEST(PictureSession, shows_the_picture_as_the_original) {
  const Mesh mesh = mesh_for(5);
  RunOptions options = against_picture_by(mesh);
  options.rules = block_rules();
  options.gradient_rules = gradient_rules({});
  // A picture that no mesh paints, so that what is shown can come of nothing else.
  const Frame frame = fit_frame(mesh, {}, resolution);
  Image image = paint_whole(mesh, frame).image;
  fill(image, Window{30, 30, 40, 50}, std::uint8_t(10));
  options.original = original_of(test::with_opacities(image), frame.to_pixels.inverse());
  Session session(test::problem(mesh, options));

  SessionView view;
  view.width = frame.width, view.height = frame.height;
  view.to_pixels = frame.to_pixels;
  view.lines = false;
  view.ground = SessionView::Ground::original;
  EXPECT_EQ(paint(session, view), image);
  view.ground = SessionView::Ground::halves;
  const Image halves = paint(session, view);
  EXPECT_EQ(halves.pixel(35, 40), image.pixel(35, 40));
  EXPECT_EQ(halves.pixel(90, 40), paint_whole(mesh, frame).image.pixel(90, 40));
  view.ground = SessionView::Ground::error;
  const Image errors = paint(session, view);
  EXPECT_NE(errors.pixel(35, 40), errors.pixel(90, 40));

  session.curves().request(MeshKind::one_gradient);
  session.curves().wait();
  const auto states = session.curves().found(MeshKind::one_gradient)->curve.states.size();
  ASSERT_GT(states, 1u);
  session.show(MeshKind::one_gradient, int(states) - 1, false);
  view.ground = SessionView::Ground::original;
  EXPECT_EQ(paint(session, view), image);
}

}  // namespace
}  // namespace gradmesh
