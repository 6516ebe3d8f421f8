// What a person sees and does in the window of simplifying by eye (window/view/eye_window.h). No
// display is needed.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "eye_windows.h"
#include "window/toolkit/catalogue.h"

namespace gradmesh {
namespace {

using test::EyeWindows;
using test::ordinary_size;
using test::same;

TEST_F(EyeWindows, the_first_frame_shows_mesh_and_panel) {
  open("ellipse");
  std::set<std::uint32_t> colors;
  for (int y = 0; y < ordinary_size.y; y += 7)
    for (int x = 0; x < 700; x += 7) colors.insert(screen_->pixel(x, y));
  EXPECT_GT(colors.size(), 500u) << "a gradient has many colours";
  for (const char* label : {"Result", "Error", "Lines", "Take out", "Mark", "Undo", "Cancel"})
    EXPECT_TRUE(screen_->window().ui().place_of(label)) << label;
}

TEST_F(EyeWindows, the_slider_goes_along_the_curve_and_is_one_step_of_undo) {
  open("ellipse");
  wait_for_curve();
  const int before = handles();
  const glm::dvec2 middle = *screen_->window().ui().place_of("curve");
  screen_->drag({middle - glm::dvec2(100, 0), middle, middle + glm::dvec2(80, 0)});
  EXPECT_LT(handles(), before);
  EXPECT_GT(session().shown().state(), 0);
  screen_->click("Undo");
  EXPECT_EQ(handles(), before);
  EXPECT_FALSE(session().history().can_undo());
  screen_->click("Redo");
  EXPECT_LT(handles(), before);
}

TEST_F(EyeWindows, arrows_and_amounts_choose_states) {
  open("ellipse");
  wait_for_curve();
  screen_->key("Right");
  screen_->key("Right");
  EXPECT_EQ(session().shown().state(), 2);
  screen_->key("Left");
  EXPECT_EQ(session().shown().state(), 1);
  const auto found = eye_->curve();
  ASSERT_EQ(found->curve.marks.size(), 3u);
  for (const auto& [label, number] : {std::pair("Gentle", 0), {"Balanced", 1}, {"Strong", 2}}) {
    screen_->click(label);
    EXPECT_EQ(session().shown().state(), found->curve.marks[std::size_t(number)].state) << label;
  }
  screen_->key("End");
  EXPECT_EQ(session().shown().state(), int(found->curve.states.size()) - 1);
  screen_->key("Home");
  EXPECT_TRUE(session().shown().is_unchanged());
}

TEST_F(EyeWindows, pointing_at_a_line_shows_what_it_costs_and_a_click_takes_it_out) {
  open("ellipse");
  const auto untouched = pixels();
  screen_->move(on_a_line());
  ASSERT_TRUE(session().hands().proposal());
  const int promised = session().hands().proposal()->written.counts().handles;
  EXPECT_NE(pixels(), untouched);
  EXPECT_TRUE(session().shown().is_unchanged()) << "nothing is made by pointing";
  screen_->click(on_a_line());
  EXPECT_EQ(handles(), promised);
  EXPECT_EQ(session().history().undo_name()->english(), "Take out a line");
}

TEST_F(EyeWindows, escape_lets_go_of_one_thing_after_another) {
  open("ellipse");
  const auto is_list_open = [&] {
    return screen_->window().ui().place_of("What lines cost").has_value();
  };
  screen_->key("K");
  screen_->click(middle_of(*session().mesh().faces().begin()));
  screen_->click("known");
  EXPECT_TRUE(is_list_open());
  screen_->key("Escape");
  EXPECT_FALSE(is_list_open());
  EXPECT_EQ(eye_->marked().size(), 1u);
  screen_->key("Escape");
  EXPECT_TRUE(eye_->marked().empty());
  screen_->move(on_a_line());
  EXPECT_FALSE(session().hands().proposal()) << "the tool is still that for marks";
  screen_->key("Escape");
  screen_->move(middle_of(*session().mesh().faces().begin()));
  screen_->move(on_a_line());
  EXPECT_TRUE(session().hands().proposal()) << "a click takes a line out again";
  EXPECT_TRUE(screen_->frame());
  screen_->key("Escape");
  EXPECT_FALSE(screen_->frame());
}

TEST_F(EyeWindows, escape_closes_the_picker_of_colours_alone) {
  open("ellipse");
  screen_->click("Look");
  screen_->click(seen_at(session().mesh().patch(Face{0}).at(1, 1).position));
  ASSERT_TRUE(eye_->element.point.valid());
  screen_->settle();
  const auto colour = screen_->window().ui().place_of("colour");
  ASSERT_TRUE(colour);
  const auto is_picker_open = [] { return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup); };
  // The field with the colour itself is right of those with numbers.
  for (int x = 0; x < 200 && !is_picker_open(); x += 8) screen_->click(*colour + glm::dvec2(x, 0));
  ASSERT_TRUE(is_picker_open());
  screen_->key("Escape");
  EXPECT_FALSE(is_picker_open());
  EXPECT_TRUE(screen_->is_open());
}

TEST_F(EyeWindows, a_new_cross_goes_where_the_pointer_is) {
  open("ellipse");
  const int before = handles();
  screen_->key("B");
  const Face face = *session().mesh().faces().begin();
  screen_->move(middle_of(face));
  ASSERT_TRUE(session().hands().proposal());
  screen_->click(middle_of(face));
  EXPECT_GT(handles(), before);
}

TEST_F(EyeWindows, a_point_is_dragged_and_the_picture_follows) {
  open("ellipse");
  screen_->key("G");
  const Mesh mesh = session().mesh();
  // A point inside the mesh.
  const auto is_inside = [&](Halfedge curve) { return mesh[curve].twin.valid(); };
  Halfedge curve;
  for (const Halfedge each : mesh.curves())
    if (is_inside(each) && is_inside(mesh.curve(mesh.next(each)))) curve = each;
  const Point point = mesh.end(curve);
  const glm::dvec2 at = seen_at(mesh.position(point));
  screen_->drag({at, at + glm::dvec2(8, 6), at + glm::dvec2(10, 7)});
  EXPECT_EQ(session().history().undo_name()->english(), "Move a point");
  const glm::dvec2 now = seen_at(session().mesh().position(point));
  EXPECT_NEAR(now.x, at.x + 10, 0.1);
  EXPECT_NEAR(now.y, at.y + 7, 0.1);
}

TEST_F(EyeWindows, the_wheel_moves_and_zooms_at_the_pointer) {
  open("ellipse");
  screen_->move({300, 200});
  const glm::dvec2 place = eye_->viewport().place_at({300, 200});
  const double scale = eye_->viewport().scale();
  screen_->turn_wheel(1, {.control = true});
  EXPECT_GT(eye_->viewport().scale(), scale);
  EXPECT_NEAR(eye_->viewport().place_at({300, 200}).x, place.x, 1e-6);
  screen_->turn_wheel(-1);
  EXPECT_GT(eye_->viewport().place_at({300, 200}).y, place.y);
  screen_->key("5");
  EXPECT_DOUBLE_EQ(eye_->viewport().scale(), scale);
}

TEST_F(EyeWindows, the_original_is_shown_while_a_key_is_held) {
  open("ellipse");
  wait_for_curve();
  screen_->click("Lines");
  screen_->key("End");
  const auto result = pixels();
  screen_->frame({{{"F", true}}, false});
  EXPECT_NE(pixels(), result);
  screen_->frame({{{"F", false}}, false});
  EXPECT_EQ(pixels(), result);
}

TEST_F(EyeWindows, the_line_between_original_and_result_is_dragged) {
  open("ellipse");
  screen_->click("Both");
  const double line = 0.5 * eye_->viewport().size().x;
  screen_->drag({{line, 300}, {line + 60, 300}, {line + 120, 310}});
  EXPECT_NEAR(eye_->looks.split * eye_->viewport().size().x, line + 120, 1);
}

TEST_F(EyeWindows, the_worst_places_are_gone_to) {
  open("ellipse");
  wait_for_curve();
  screen_->key("End");
  const auto worst = eye_->worst_places();
  ASSERT_FALSE(worst.empty());
  screen_->click("worst 1");
  const glm::dvec2 seen = seen_at(worst.front().place), middle = eye_->viewport().size() / 2.0;
  EXPECT_NEAR(seen.x, middle.x, 1);
  EXPECT_NEAR(seen.y, middle.y, 1);
}

TEST_F(EyeWindows, what_is_known_comes_once_it_is_found_out) {
  open("ellipse");
  const auto untouched = pixels();
  screen_->click("known");
  screen_->click("What lines cost");
  EXPECT_EQ(eye_->looks.known, AnalysisKind::prices);
  session().analyses().wait();
  screen_->settle();
  EXPECT_TRUE(eye_->known());
  EXPECT_NE(pixels(), untouched);
  EXPECT_FALSE(session().shown().problem().mesh().is_smooth());
  screen_->key("S");
  EXPECT_EQ(eye_->looks.known, AnalysisKind::regions);
}

TEST_F(EyeWindows, nobody_stops_drawing_before_what_was_found_is_seen) {
  open("ellipse");
  wait_for_curve();
  EXPECT_FALSE(eye_->is_busy());
  screen_->frame({{{"S", true}}, false});
  session().analyses().wait();
  EXPECT_TRUE(eye_->is_busy()) << "it is found, but no frame has shown it";
  screen_->frame();
  EXPECT_FALSE(eye_->is_busy());
  EXPECT_TRUE(eye_->known());
}

TEST_F(EyeWindows, the_structure_is_walked_by_buttons) {
  open("ellipse");
  screen_->click("Look");
  const Mesh& mesh = session().mesh();
  const Face face = *mesh.faces().begin();
  screen_->click(middle_of(face));
  EXPECT_EQ(eye_->element.face, face);
  EXPECT_FALSE(screen_->click("Right")) << "numbers are for who asks";
  ASSERT_TRUE(screen_->click("details"));
  ASSERT_TRUE(screen_->click("Right"));
  const Halfedge side = eye_->element.halfedge;
  EXPECT_EQ(side, mesh.sides(face)[1]);
  ASSERT_TRUE(screen_->click("Next"));
  EXPECT_EQ(eye_->element.halfedge, mesh.next(side));
  ASSERT_TRUE(screen_->click("Previous"));
  ASSERT_TRUE(screen_->click("Twin"));
  EXPECT_EQ(eye_->element.halfedge, mesh.other_side(side));
  ASSERT_TRUE(screen_->click("Start"));
  EXPECT_EQ(eye_->element.point, mesh.origin(mesh.other_side(side)));
}

TEST_F(EyeWindows, a_patch_that_forbids_an_edit_is_lit_up) {
  open("ellipse");
  const Mesh& mesh = session().mesh();
  const std::vector<Halfedge> curves = mesh.curves();
  const Halfedge curve =
      *std::ranges::find_if(curves, [&](Halfedge h) { return mesh[h].twin.valid(); });
  const Face face = mesh.face(curve);
  session().protection().protect({face}, true);
  screen_->key("M");
  screen_->move(seen_at(session().mesh().curve_of(curve).at(0.5).position));
  EXPECT_TRUE(session().mesh().is_fixed(eye_->forbids()));
  screen_->move({-50, -50});
  screen_->settle();
  EXPECT_FALSE(eye_->forbids().valid());
}

TEST_F(EyeWindows, of_both_the_lines_are_on_the_side_of_the_result) {
  open("ellipse");
  screen_->key("9");
  const auto with_lines = pixels();
  screen_->key("L");
  const auto without = pixels();
  const int line = int(eye_->looks.split * eye_->viewport().size().x);
  int left = 0, right = 0;
  for (int y = 0; y < int(eye_->viewport().size().y); ++y)
    for (int x = 0; x < int(eye_->viewport().size().x); ++x) {
      const std::size_t i = std::size_t(y) * ordinary_size.x + x;
      if (with_lines[i] != without[i]) ++(x < line ? left : right);
    }
  EXPECT_EQ(left, 0);
  EXPECT_GT(right, 100);
}

TEST_F(EyeWindows, what_cannot_be_done_is_said_and_nothing_is_lost) {
  open("smooth");
  const int before = handles();
  screen_->key("R");
  screen_->move(middle_of(*session().mesh().faces().begin()));
  EXPECT_TRUE(eye_->why_not());
  screen_->click(middle_of(*session().mesh().faces().begin()));
  EXPECT_EQ(handles(), before);
}

TEST_F(EyeWindows, the_picture_is_the_sessions_to_the_pixel) {
  open("face");
  wait_for_curve();
  screen_->click("Strong");
  screen_->click("Handles");
  screen_->move({5, ordinary_size.y - 5});
  const Image image = paint(session(), eye_->view());
  ASSERT_GT(image.width, 600);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto [red, green, blue] = image.pixel(x, y);
      ASSERT_EQ(screen_->pixel(x, y), std::uint32_t(red << 16 | green << 8 | blue))
          << x << ", " << y;
    }
}

TEST_F(EyeWindows, no_words_are_cut_off) {
  for (const std::string language : {"en", "de"})
    for (const bool is_dark : {false, true})
      for (const glm::ivec2 size : {glm::ivec2(720, 540), glm::ivec2(800, 600), ordinary_size}) {
        SCOPED_TRACE(language + " " + std::to_string(size.x));
        open("two", is_dark, 1, translation_into({language}), size);
        const auto expect_all_fits = [&] {
          EXPECT_EQ(screen_->window().ui().clipped(), std::set<std::string>());
        };
        const Mesh& mesh = session().mesh();
        expect_all_fits();
        eye_->element.point = mesh.origin(mesh.sides(*mesh.faces().begin())[0]);
        screen_->settle();
        expect_all_fits();
        ASSERT_TRUE(screen_->click("details"));
        expect_all_fits();
        eye_->mark({*mesh.faces().begin()}, false);
        session().protection().weigh(eye_->marked(), 4);
        screen_->settle();
        expect_all_fits();
        for (const char* key : {"S", "S", "S"}) {
          screen_->key(key);
          session().analyses().wait();
          screen_->settle();
          expect_all_fits();
        }
        screen_->key("M");
        screen_->move(on_a_line());
        screen_->settle();
        expect_all_fits();
        // The question of what was made by hand.
        screen_->frame({{}, true});
        screen_->settle();
        expect_all_fits();
      }
}

TEST_F(EyeWindows, dark_and_light_large_and_small_screens_show_the_same) {
  for (const bool is_dark : {false, true})
    for (const float density : {1.0F, 2.0F}) {
      const auto size = glm::ivec2(glm::dvec2(ordinary_size) * double(density));
      open("ellipse", is_dark, density, same, size);
      const std::uint32_t ground = screen_->pixel(size.x - 3, size.y / 2);
      EXPECT_EQ((ground & 255) < 128, is_dark);
      EXPECT_TRUE(screen_->click("Error"));
      EXPECT_EQ(eye_->looks.ground, SessionView::Ground::error);
      EXPECT_TRUE(screen_->click("Cancel"));
      EXPECT_FALSE(screen_->is_open());
    }
}

/// Documents that people have made, beside the project.
std::vector<std::filesystem::path> real_documents() {
  std::vector<std::filesystem::path> all;
  for (const std::string folder : {GRADMESH_SHARED_DIR "/real", GRADMESH_SHARED_DIR "/meshes"}) {
    if (!std::filesystem::exists(folder)) continue;
    for (const auto& file : std::filesystem::directory_iterator(folder))
      if (file.path().extension() == ".svg" || file.path().filename() == "global_duck.hemesh")
        all.push_back(file.path());
  }
  std::ranges::sort(all);
  return all;
}

TEST_F(EyeWindows, all_tools_work_on_documents_that_people_have_made) {
  const auto files = real_documents();
  if (files.empty()) GTEST_SKIP() << "the documents are not beside the project";
  int opened = 0;
  for (const auto& file : files) {
    SCOPED_TRACE(file.filename().string());
    try {
      open_file(file);
    } catch (const InputError&) {
      continue;  // There is no mesh in it that can be read.
    }
    ++opened;
    const glm::dvec2 middle = eye_->viewport().size() / 2.0;
    for (const char* key : {"M", "R", "C", "B", "G", "K", "T", "I"}) {
      screen_->key(key);
      for (const glm::dvec2 aside : {glm::dvec2(0), {-40, 25}, {30, -60}})
        screen_->move(middle + aside);
      screen_->click(middle + glm::dvec2(7, 3));
    }
    screen_->key("T");
    screen_->drag({middle, middle + glm::dvec2(90, 40)});
    screen_->key("P");
    while (session().history().can_undo()) screen_->key("Z", {.control = true});
    EXPECT_TRUE(session().shown().is_unchanged());
    EXPECT_EQ(session().shown().now().error, 0);
  }
  EXPECT_GE(opened, 20);
}

}  // namespace
}  // namespace gradmesh
