// How a person ends what they do in the window of simplifying by eye, and what of it is kept.
#include <gtest/gtest.h>

#include "app/pages/read_document.h"
#include "eye_windows.h"

namespace gradmesh {
namespace {

using test::EyeWindows;
using test::ordinary_size;
using test::same;

TEST_F(EyeWindows, closing_asks_only_where_hand_work_would_be_lost) {
  open("ellipse");
  wait_for_curve();
  screen_->key("End");
  screen_->frame({{}, true});
  EXPECT_FALSE(screen_->is_open()) << "a slider is soon where it was";
  EXPECT_FALSE(screen_->window().applies());

  open("ellipse");
  screen_->click(on_a_line());
  screen_->frame({{}, true});
  screen_->settle();
  EXPECT_TRUE(screen_->is_open());
  screen_->click("Go Back");
  EXPECT_TRUE(screen_->is_open());
  screen_->frame({{}, true});
  screen_->key("Escape");
  EXPECT_TRUE(screen_->is_open()) << "Escape goes back";
  screen_->frame({{}, true});
  screen_->settle();
  screen_->click("Discard");
  EXPECT_FALSE(screen_->is_open());
  EXPECT_FALSE(screen_->window().applies());
}

TEST_F(EyeWindows, what_is_shown_is_what_is_applied) {
  open("ellipse");
  EXPECT_TRUE(eye_->changed().empty());
  screen_->key("Return", {.control = true});
  EXPECT_TRUE(screen_->is_open()) << "there is nothing to apply";
  wait_for_curve();
  screen_->click("Balanced");
  screen_->click("Apply");
  EXPECT_FALSE(screen_->is_open());
  EXPECT_TRUE(screen_->window().applies());
  ASSERT_EQ(eye_->changed().size(), 1u);
}

TEST_F(EyeWindows, each_mesh_keeps_what_was_made_of_it) {
  open("two");
  ASSERT_EQ(eye_->ids().size(), 2u);
  wait_for_curve();
  screen_->key("End");
  const int first = handles();
  screen_->click("meshes");
  screen_->click("mesh 2");
  EXPECT_EQ(eye_->id(), eye_->ids()[1]);
  EXPECT_TRUE(session().shown().is_unchanged());
  eye_->choose(0);
  EXPECT_EQ(handles(), first);
  EXPECT_EQ(eye_->changed().size(), 1u);
}

TEST_F(EyeWindows, a_mesh_that_cannot_be_opened_takes_nothing_along) {
  document_ = read_document(std::string(GRADMESH_SOURCE_DIR) + "/samples/two.svg");
  eye_.emplace(std::vector<std::string>{"stalk", "cap"}, [this](const std::string& id) {
    if (id == "cap") throw InputError("the mesh covers no pixel.");
    return edit_by_eye(*document_, document_->selected({id}).front(), {});
  });
  screen_.emplace(*eye_, ordinary_size.x, ordinary_size.y, same);
  screen_->click(on_a_line());
  const int made = handles();
  screen_->click("meshes");
  screen_->click("mesh 2");
  EXPECT_EQ(eye_->id(), "stalk");
  EXPECT_EQ(eye_->refusal()->english(), "the mesh covers no pixel.");
  EXPECT_EQ(handles(), made);
  EXPECT_TRUE(screen_->is_open());
}

}  // namespace
}  // namespace gradmesh
