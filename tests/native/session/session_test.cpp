// What a person does to a mesh by eye (session/session.h), without a window.
#include "session/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>

#include "any_deeds.h"
#include "base/error.h"
#include "mesh/rectangle.h"
#include "mesh/validate.h"
#include "raster/painter.h"
#include "sessions.h"
#include "simplify/state_curve.h"
#include "trial/measured_surface.h"

namespace gradmesh {
namespace {

using test::mesh_for;
using test::problem_for;
using test::view_of;

const StateCurve& found(Session& session, MeshKind kind) {
  session.curves().request(kind);
  session.curves().wait();
  static StateCurve curve;
  curve = session.curves().found(kind)->curve;
  return curve;
}

std::optional<Pointed> point(const Session& session, glm::dvec2 place, double reach) {
  return pointed_at(session.mesh(), view_of(session).to_pixels, place, reach);
}

constexpr double anywhere = 1000;
const glm::dvec2 middle(100, 100);

TEST(Curve, begins_with_the_mesh_and_loses_handles_from_state_to_state) {
  const Problem problem = problem_for(mesh_for(1));
  for (const MeshKind kind : curve_kinds(problem)) {
    StopWatch watch(0, {});
    const StateCurve curve = find_curve(problem, kind, watch);
    ASSERT_GT(curve.states.size(), 2u) << name(kind);
    EXPECT_EQ(curve.states.front().mesh->face_count(), problem.mesh().face_count());
    for (std::size_t i = 1; i < curve.states.size(); ++i)
      EXPECT_LT(curve.states[i].counts.handles, curve.states[i - 1].counts.handles) << i;
    ASSERT_EQ(curve.marks.size(), all_amounts().size());
    for (std::size_t i = 0; i < curve.marks.size(); ++i) {
      const CurveState& state = curve.states[std::size_t(curve.marks[i].state)];
      const Bounds bounds = bounds_of(all_amounts()[i], problem.metric());
      EXPECT_EQ(curve.marks[i].amount, all_amounts()[i].name);
      EXPECT_LE(state.error, bounds.epsilon);
      EXPECT_LE(state.local_error, *bounds.local);
    }
  }
}

TEST(Curve, is_the_same_for_any_number_of_threads) {
  const auto curve_with = [](int threads) {
    Problem problem = problem_for(mesh_for(2));
    problem.threads = threads;
    StopWatch watch(0, {});
    return find_curve(problem, MeshKind::one_gradient, watch);
  };
  const StateCurve one = curve_with(1), three = curve_with(3);
  ASSERT_EQ(one.states.size(), three.states.size());
  for (std::size_t i = 0; i < one.states.size(); ++i)
    EXPECT_EQ(*one.states[i].mesh, *three.states[i].mesh);
}

TEST(Session, changes_no_lines_where_a_protected_patch_is_no_coons_patch) {
  Session session(problem_for(mesh_for(2)));
  session.protection().protect({{0}}, true);
  const Mesh before = session.mesh();
  const Halfedge far = before.sides(Face{18})[1];
  EXPECT_THROW(session.hands().propose(Pointed{.face = Face{18}, .edge = far}, HandEdit::merge),
               InputError);
  EXPECT_THROW(session.hands().fit(), InputError);
  EXPECT_EQ(session.mesh(), before);
}

TEST(Session, shows_the_states_of_its_curve) {
  Session session(problem_for(mesh_for(1)));
  EXPECT_TRUE(session.shown().is_unchanged());
  const StateCurve& curve = found(session, MeshKind::one_gradient);
  for (int i = int(curve.states.size()) - 1; i >= 0; --i) {
    session.show(MeshKind::one_gradient, i, true);
    EXPECT_EQ(session.mesh(), *curve.states[std::size_t(i)].mesh);
    EXPECT_EQ(session.shown().now().error, curve.states[std::size_t(i)].error);
    EXPECT_EQ(session.shown().now().counts().handles, curve.states[std::size_t(i)].counts.handles);
  }
  // Nothing of that was recorded.
  EXPECT_FALSE(session.history().can_undo());
  session.show(MeshKind::one_gradient, 1, false);
  EXPECT_TRUE(session.history().can_undo());
  EXPECT_THROW(session.show(MeshKind::one_gradient, int(curve.states.size()), false),
               std::invalid_argument);
}

TEST(Session, a_click_on_a_line_takes_it_out_as_was_shown_before) {
  Session session(problem_for(mesh_for(3)));
  const Proposal& proposal =
      session.hands().propose(*point(session, middle, anywhere), HandEdit::merge);
  const Mesh shown = proposal.written.mesh;
  const double error = proposal.written.error;
  EXPECT_EQ(shown.face_count(), 20);
  EXPECT_EQ(proposal.made.gone.size(), 5u);
  ASSERT_TRUE(session.hands().make());
  EXPECT_EQ(session.mesh(), shown);
  EXPECT_EQ(session.shown().now().error, error);
  EXPECT_EQ(session.shown().state(), -1);
  EXPECT_TRUE(find_grid(session.mesh()));
  EXPECT_FALSE(session.hands().make()) << "nothing is proposed any more";
}

TEST(Session, new_lines_of_one_gradient_change_nothing_that_is_seen) {
  for (const auto& [edit, patches, lines] :
       {std::tuple(HandEdit::split_rows, 30, 5u), std::tuple(HandEdit::split_columns, 30, 5u),
        std::tuple(HandEdit::split_both, 36, 12u)}) {
    Session session(problem_for(mesh_for(4)));
    EXPECT_EQ(session.hands().propose(*point(session, middle + 7.0, 0), edit).made.come.size(),
              lines);
    session.hands().make();
    EXPECT_EQ(session.mesh().face_count(), patches);
    EXPECT_TRUE(find_grid(session.mesh()));
    // Colours of new points are rounded to 8 bits; FLIP of a whole level everywhere is 0.03.
    EXPECT_LT(session.shown().now().error, 0.006);
  }
}

TEST(Session, patches_of_blocks_are_merged_and_split_alone) {
  Session session(problem_for(mesh_for(5)));
  session.hands().set_form(MeshKind::blocks);
  session.hands().propose(*point(session, middle, anywhere), HandEdit::merge);
  session.hands().make();
  EXPECT_EQ(session.mesh().face_count(), 24);
  EXPECT_EQ(validate(session.mesh()), std::vector<std::string>{});
  session.hands().propose(*point(session, middle, 0), HandEdit::split_both);
  session.hands().make();
  EXPECT_EQ(session.mesh().face_count(), 27);
  EXPECT_THROW(session.hands().set_form(MeshKind::one_gradient), InputError);
  session.undo();
  session.undo();
  EXPECT_FALSE(session.shown().is_unchanged()) << "blocks would be written as a group";
  session.undo();
  EXPECT_TRUE(session.shown().is_unchanged());
}

TEST(Session, fits_lower_the_error_of_what_is_taken_out) {
  const auto error_with = [](bool fits) {
    Session session(problem_for(mesh_for(6)));
    session.hands().set_fits(fits);
    return session.hands()
        .propose(*point(session, middle, anywhere), HandEdit::merge)
        .written.error;
  };
  EXPECT_LT(error_with(true), error_with(false));
}

TEST(Session, nothing_lies_beside_the_mesh) {
  Session session(problem_for(mesh_for(1)));
  EXPECT_FALSE(point(session, glm::dvec2(-500), 8));
  EXPECT_FALSE(session.hands().make());
}

/// Whatever is done in whatever order, the meshes are sound, what is protected stays, and undo and
/// redo give the very same.
TEST(Session, any_sequence_ends_in_sound_meshes_and_can_be_taken_back) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    std::mt19937 random(seed);
    Session session(problem_for(mesh_for(seed)));
    found(session, MeshKind::one_gradient);
    test::AnyDeeds deeds(session, [&] { return unsigned(random() % 256); });
    for (int step = 0; step < 40; ++step) {
      deeds.next();
      ASSERT_EQ(deeds.broken(), "") << "seed " << seed << ", step " << step;
    }
    ASSERT_EQ(deeds.broken_by_going_back(), "") << "seed " << seed;
  }
}

/// Returns the state of the curve that is that of an amount.
int state_of(Session& session, const std::string& amount) {
  const StateCurve& curve = found(session, session.shown().form());
  for (const StateCurve::Mark& mark : curve.marks)
    if (mark.amount == amount) return mark.state;
  ADD_FAILURE() << "there is no mark for " << amount;
  return 0;
}

/// Returns the colour of the mesh that is shown at the pixel of the problem's frame.
std::array<std::uint8_t, 3> shown_at(const Session& session, glm::dvec2 place) {
  const Frame& frame = session.shown().problem().frame();
  const glm::dvec2 pixel = frame.to_pixels.point(place);
  return paint_whole(session.shown().now().surface(), frame)
      .image.pixel(int(pixel.x), int(pixel.y));
}

int levels_apart(const std::array<std::uint8_t, 3>& a, const std::array<std::uint8_t, 3>& b) {
  int most = 0;
  for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(int(a[c]) - int(b[c])));
  return most;
}

TEST(Session, a_state_keeps_a_colour_that_was_set_by_hand) {
  for (const MeshKind form : {MeshKind::one_gradient, MeshKind::blocks})
    for (const bool is_simple_before : {false, true}) {
      Session session(problem_for(mesh_for(2)));
      session.hands().set_form(form);
      if (is_simple_before) session.show(form, state_of(session, "balanced"), false);
      const Mesh& mesh = session.mesh();
      const Halfedge corner = mesh.sides(Face{0})[2];
      const glm::dvec2 place = mesh[mesh.origin(corner)].position;
      const auto before = shown_at(session, place);
      session.hands().propose_color(Pointed{.face = Face{0}, .corner = corner}, {0, 1, 0}, false);
      ASSERT_TRUE(session.hands().make());
      const auto green = shown_at(session, place);
      ASSERT_GT(levels_apart(before, green), 60);
      const double error = session.shown().now().error;
      EXPECT_GT(error, 0) << "it is measured against the picture as it was";
      session.show(form, state_of(session, "balanced"), false);
      EXPECT_LT(levels_apart(shown_at(session, place), green), 12);
      EXPECT_LT(session.shown().now().error, error) << "what was set by hand is what counts";
      session.undo();
      EXPECT_EQ(shown_at(session, place), green);
      EXPECT_EQ(session.shown().now().error, error);
      session.undo();
      EXPECT_EQ(shown_at(session, place), before);
      EXPECT_FALSE(session.shown().is_made_by_hand());
    }
}

TEST(Session, a_state_keeps_a_point_that_was_moved_by_hand) {
  Session session(problem_for(mesh_for(2)));
  const Mesh& mesh = session.mesh();
  const Halfedge corner = mesh.sides(Face{6})[2];
  const Point point = mesh.origin(corner);
  const glm::dvec2 place = mesh[point].position;
  session.hands().propose_move(Grip{.point = point},
                               place + 0.3 * (mesh.curve_of(corner).at(1).position - place));
  ASSERT_TRUE(session.hands().make());
  const Mesh edited = session.mesh();
  session.show(session.shown().form(), state_of(session, "strong"), false);
  EXPECT_LT(session.shown().now().counts().handles, counts_of(edited).handles);
  // Against the mesh as it was edited, not against that with the point where it was.
  const auto away_from = [&](const Mesh& original) {
    const Reference reference(original, session.shown().problem().frame(), MetricKind::flip);
    return MeasuredSurface(reference, session.shown().now().surface(), false, nullptr).error().mean;
  };
  EXPECT_LT(away_from(edited), away_from(session.shown().start().mesh));
  EXPECT_NEAR(away_from(edited), session.shown().now().error, 0.01);
}

TEST(Session, a_state_is_made_of_the_mesh_without_the_line_that_was_taken_out) {
  Session session(problem_for(mesh_for(3)));
  session.hands().propose(*point(session, middle, anywhere), HandEdit::merge);
  session.hands().make();
  const Mesh edited = session.mesh();
  const StateCurve& curve = found(session, MeshKind::one_gradient);
  EXPECT_EQ(*curve.states.front().mesh, edited);
  session.show(MeshKind::one_gradient, 0, false);
  EXPECT_EQ(session.mesh(), edited);
  EXPECT_FALSE(session.shown().is_unchanged());
  EXPECT_TRUE(session.shown().problem_as_written().original()->mesh()) << "nothing was drawn anew";
}

TEST(Session, what_is_drawn_anew_is_the_original_of_later_runs) {
  Session session(problem_for(mesh_for(2)));
  const Mesh& mesh = session.mesh();
  const Halfedge side = mesh.sides(Face{6})[2];
  session.hands().propose_move(Grip{.point = mesh.origin(side)},
                               mesh.curve_of(side).at(0.3).position);
  session.hands().make();
  EXPECT_FALSE(session.shown().problem_as_written().original()->mesh());
  EXPECT_EQ(session.shown().problem_as_written().mesh(), session.shown().start().mesh);
  session.undo();
  EXPECT_TRUE(session.shown().problem_as_written().original()->mesh());
}

TEST(Session, errors_count_more_where_a_person_says_so) {
  Session session(problem_for(mesh_for(2)));
  const StateCurve& curve = found(session, MeshKind::one_gradient);
  const int state = int(curve.states.size()) - 1;
  session.show(MeshKind::one_gradient, state, false);
  const double error = session.shown().now().error;
  const std::vector<Face> all(session.mesh().faces().begin(), session.mesh().faces().end());
  EXPECT_THROW(session.protection().weigh(all, 5), InputError);
  EXPECT_THROW(session.protection().weigh({}, 2), InputError);
  session.protection().weigh(all, 4);
  EXPECT_GT(session.shown().now().error, 3 * error);
  EXPECT_LE(session.shown().now().error, 4 * error);
  EXPECT_EQ(session.shown().start().error, 0);
  session.protection().weigh(all, 0.25);
  EXPECT_LT(session.shown().now().error, error / 3) << "the last weights count";
  EXPECT_EQ(session.history().undo_name()->english(), "Let errors count otherwise");
  session.undo();
  session.undo();
  EXPECT_EQ(session.shown().now().error, error);
  EXPECT_EQ(session.shown().problem().frame().weights, nullptr);
  session.redo();
  EXPECT_GT(session.shown().now().error, 3 * error);
}

TEST(Session, other_weights_leave_no_state_but_the_start) {
  Session session(problem_for(mesh_for(2)));
  const Mesh& shown = session.mesh();
  const auto all = [&] { return std::vector<Face>(shown.faces().begin(), shown.faces().end()); };
  session.protection().weigh(all(), 4);
  EXPECT_EQ(session.shown().state(), 0);
  const int state = int(found(session, MeshKind::one_gradient).states.size()) - 1;
  session.show(MeshKind::one_gradient, state, false);
  session.protection().weigh(all(), 2);
  EXPECT_EQ(session.shown().state(), -1) << "the new curve has another mesh there";
  session.undo();
  EXPECT_EQ(session.shown().state(), state);
}

TEST(Session, curves_keep_more_where_errors_count_more) {
  const auto handles_at_balanced = [](double factor) {
    Session session(problem_for(mesh_for(2)));
    const Mesh& mesh = session.mesh();
    session.protection().weigh({mesh.faces().begin(), mesh.faces().end()}, factor);
    const StateCurve& curve = found(session, MeshKind::one_gradient);
    return curve.states[std::size_t(curve.marks[1].state)].counts.handles;
  };
  EXPECT_GT(handles_at_balanced(4), handles_at_balanced(0.25));
}

TEST(Session, a_history_of_small_edits_is_small) {
  Session session(
      problem_for(test::grid_mesh({.rows = 12, .columns = 12, .color_noise = 0.05}, 1)));
  session.hands().set_form(MeshKind::blocks);
  session.hands().set_fits(false);
  session.hands().propose(*point(session, middle, anywhere), HandEdit::merge);
  session.hands().make();
  const std::size_t of_one = session.history().bytes();
  Session whole(problem_for(test::grid_mesh({.rows = 12, .columns = 12, .color_noise = 0.05}, 1)));
  whole.hands().propose(*point(whole, middle, anywhere), HandEdit::merge);
  whole.hands().make();
  EXPECT_LT(10 * of_one, whole.history().bytes());
}

TEST(Session, the_worst_places_are_apart_and_in_order) {
  Session session(problem_for(mesh_for(7)));
  const auto states = found(session, MeshKind::one_gradient).states.size();
  session.show(MeshKind::one_gradient, int(states) - 1, false);
  const std::vector<WorstPlace> worst = session.shown().worst_places(4);
  ASSERT_EQ(worst.size(), 4u);
  EXPECT_GT(worst[0].error, session.shown().now().error);
  const double apart = 32 / session.shown().problem().frame().to_pixels.linear[0][0];
  for (std::size_t i = 1; i < worst.size(); ++i) {
    EXPECT_LE(worst[i].error, worst[i - 1].error);
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GE(glm::distance(worst[i].place, worst[j].place), apart - 1e-9);
  }
}

TEST(Session, pictures_show_what_they_are_asked_for) {
  Session session(problem_for(mesh_for(8)));
  const auto states = found(session, MeshKind::one_gradient).states.size();
  SessionView view = view_of(session);
  view.lines = false;
  view.ground = SessionView::Ground::original;
  const Image start = paint(session, view);
  session.show(MeshKind::one_gradient, int(states) - 1, false);
  EXPECT_EQ(paint(session, view), start);
  view.ground = SessionView::Ground::halves;
  const Image halves = paint(session, view);
  view.ground = SessionView::Ground::result;
  const Image result = paint(session, view);
  EXPECT_NE(result, start);
  for (int y = 0; y < view.height; y += 7) {
    EXPECT_EQ(halves.pixel(60, y), start.pixel(60, y));
    EXPECT_EQ(halves.pixel(140, y), result.pixel(140, y));
  }
  view.handles = true;
  EXPECT_NE(paint(session, view), result);
  view.width = 0;
  EXPECT_THROW(paint(session, view), std::invalid_argument);
}

TEST(Session, patches_are_split_as_long_as_they_have_a_size_as_written) {
  Session session(problem_for(mesh_for(2)));
  session.hands().set_fits(false);
  const auto put_in = [&] {
    for (int i = 0; i < 60; ++i) {
      session.hands().propose(*point(session, {100, 100}, 0), HandEdit::split_both);
      session.hands().make();
    }
  };
  EXPECT_THROW(put_in(), InputError);
  EXPECT_GT(session.shown().now().surface().face_count(), 8 * 8);
  for (const Face face : session.shown().now().surface().faces()) {
    const Patch patch = session.shown().now().surface().patch(face);
    double longest = 0;
    for (int k = 0; k < 4; ++k)
      longest =
          std::max(longest, glm::length(patch.side(k).p1.position - patch.side(k).p0.position));
    EXPECT_GT(longest, 0);
  }
}

TEST(Session, marks_of_smooth_meshes_lie_on_their_patches) {
  Mesh mesh = mesh_for(3);
  MeshParts parts{{}, grid_curves(5, 5)};
  for (const Face face : mesh.faces()) parts.patches.push_back(mesh.patch(face));
  parts.smooth = true;
  mesh = build_mesh(parts);
  Session session(problem_for(mesh));
  SessionView view = view_of(session);
  const Image without = paint(session, view);
  for (const int number : {0, 7, 24}) {
    view.marked = session.shown().faces_numbered({number});
    const Image with = paint(session, view);
    EXPECT_NE(with, without);
    const Window patch =
        pixel_bounds(mesh.patch(view.marked.front()),
                     {.width = view.width, .height = view.height, .to_pixels = view.to_pixels});
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x)
        if (x < patch.x0 || x >= patch.x1 || y < patch.y0 || y >= patch.y1) {
          ASSERT_EQ(with.pixel(x, y), without.pixel(x, y));
        }
  }
}

TEST(Session, the_first_state_is_the_mesh_as_it_is) {
  Session session(problem_for(mesh_for(1)));
  const MeshCounts as_it_is = counts_of(session.shown().problem().mesh());
  const CurveState first = found(session, MeshKind::one_gradient).states.front();
  EXPECT_EQ(first.counts.handles, as_it_is.handles);
  EXPECT_EQ(first.error, 0);
  EXPECT_EQ(session.shown().now().counts().handles, as_it_is.handles);
  EXPECT_EQ(session.shown().now().error, 0);
  EXPECT_TRUE(session.shown().worst_places(5).empty());
  session.show(MeshKind::one_gradient, 1, false);
  session.undo();
  EXPECT_EQ(session.shown().now().error, 0);
  session.hands().set_form(MeshKind::blocks);
  EXPECT_GT(session.shown().now().error, 0) << "blocks are written anew";
}

TEST(Session, what_protects_says_of_how_many_patches) {
  Session session(problem_for(mesh_for(1)));
  session.protection().protect({{0}, {1}, {4}}, true);
  EXPECT_EQ(session.history().undo_name()->english(), "Protect patches: 3");
  session.protection().protect({{4}}, false);
  EXPECT_EQ(session.history().undo_name()->english(), "Protect patches no longer: 1");
}

TEST(Session, only_what_is_named_may_change_whatever_was_protected_before) {
  Session session(problem_for(mesh_for(1)));
  session.protection().protect({{0}, {1}}, true);
  session.protection().protect_others({{1}, {2}});
  EXPECT_EQ(session.shown().protected_faces().size(), 23u);
  EXPECT_FALSE(session.mesh().is_fixed({1}));
  EXPECT_FALSE(session.shown().problem().mesh().is_fixed({1}));
  EXPECT_TRUE(session.shown().problem().mesh().is_fixed({3}));
  session.undo();
  EXPECT_EQ(session.shown().protected_faces(), (std::vector<Face>{{0}, {1}})) << "it was one step";
}

}  // namespace
}  // namespace gradmesh
