// A window that draws and is told what a person does (window/toolkit/sdl_window.h), on SDL's driver
// that needs no display.
#include "window/toolkit/sdl_window.h"

#include <SDL.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <atomic>
#include <cstdlib>
#include <string>
#include <thread>

#include "base/error.h"
#include "window/toolkit/imgui_versions.h"

namespace gradmesh {
namespace {

void without_display() { SDL_setenv("SDL_VIDEODRIVER", "dummy", 1); }

void push_button(Uint32 type, int x, int y) {
  SDL_Event event{};
  event.type = type;
  event.button.button = SDL_BUTTON_LEFT;
  event.button.x = x;
  event.button.y = y;
  SDL_PushEvent(&event);
}

/// Draws over all of the window.
void draw_all(const std::function<void()>& contents) {
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
  ImGui::Begin("all", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
  contents();
  ImGui::End();
}

const auto is_busy = [] { return true; };

TEST(SdlWindow, a_click_reaches_what_is_there) {
  without_display();
  SdlWindow window("test", 200, 100);
  int clicks = 0, frames = 0;
  std::uint32_t pixel = 0;
  window.run(
      [&](const Happened&) {
        // Both at once, as a quick hand does it.
        if (++frames == 3)
          for (const Uint32 type : {SDL_MOUSEBUTTONDOWN, SDL_MOUSEBUTTONUP})
            push_button(type, 40, 25);
        draw_all([&] {
          ImGui::SetCursorPos({10, 10});
          clicks += ImGui::Button("Merge", {80, 30});
        });
        return frames < 10;
      },
      // Asked between frames, when the last is seen.
      [&] {
        const Surface seen = window.surface();
        pixel = seen.pixels[15 * seen.stride + 15];
        return true;
      });
  EXPECT_EQ(clicks, 1);
  EXPECT_NE(pixel, 0u) << "the button is seen";
}

TEST(SdlWindow, what_is_typed_and_turned_arrives) {
  without_display();
  SdlWindow window("test", 200, 100);
  char text[16] = "";
  float turned = 0;
  bool is_held = false;
  int frames = 0;
  window.run(
      [&](const Happened&) {
        if (++frames == 5) {
          SDL_Event typed{};
          typed.type = SDL_TEXTINPUT;
          std::snprintf(typed.text.text, sizeof typed.text.text, "h\u00f6he");
          SDL_PushEvent(&typed);
          SDL_Event wheel{};
          wheel.type = SDL_MOUSEWHEEL;
          wheel.wheel.preciseY = 0.25F;
          SDL_PushEvent(&wheel);
        }
        // With Ctrl no letters are typed.
        if (frames == 8) {
          SDL_Event key{};
          key.type = SDL_KEYDOWN;
          key.key.keysym.scancode = SDL_SCANCODE_A;
          key.key.keysym.mod = KMOD_LCTRL;
          SDL_PushEvent(&key);
        }
        turned += ImGui::GetIO().MouseWheel;
        is_held = is_held || (is_held_down(ImGuiKey_A) && ImGui::GetIO().KeyCtrl);
        draw_all([&] {
          if (frames == 1) ImGui::SetKeyboardFocusHere();
          ImGui::InputText("name", text, sizeof text);
        });
        return frames < 12;
      },
      is_busy);
  EXPECT_EQ(std::string(text), "h\u00f6he");
  EXPECT_EQ(turned, 0.25F);
  EXPECT_TRUE(is_held);
}

TEST(SdlWindow, nothing_is_drawn_while_nothing_happens) {
  without_display();
  SdlWindow window("test", 200, 100);
  std::atomic<int> frames = 0;
  constexpr int first_and_to_settle = 4;
  bool is_told = false;
  std::thread person([&] {
    while (frames < first_and_to_settle) std::this_thread::yield();
    SDL_Event quit{};
    quit.type = SDL_QUIT;
    SDL_PushEvent(&quit);
  });
  window.run(
      [&](const Happened& happened) {
        is_told = happened.must_close;
        if (!is_told) ++frames;
        return !is_told;
      },
      [] { return false; });
  person.join();
  EXPECT_EQ(frames, first_and_to_settle);
  EXPECT_TRUE(is_told);
}

TEST(SdlWindow, keys_are_told_by_their_names) {
  without_display();
  SdlWindow window("test", 200, 100);
  std::vector<Key> keys;
  int frames = 0;
  window.run(
      [&](const Happened& happened) {
        keys.insert(keys.end(), happened.keys.begin(), happened.keys.end());
        if (++frames == 2)
          for (const Uint32 type : {SDL_KEYDOWN, SDL_KEYUP}) {
            SDL_Event key{};
            key.type = type;
            key.key.keysym = {SDL_SCANCODE_Z, SDLK_z, KMOD_LCTRL | KMOD_RSHIFT, 0};
            SDL_PushEvent(&key);
          }
        return frames < 8;
      },
      is_busy);
  ASSERT_EQ(keys.size(), 2u);
  EXPECT_EQ(keys[0].name, "Z");
  EXPECT_TRUE(keys[0].is_down && keys[0].held.control && keys[0].held.shift);
  EXPECT_FALSE(keys[0].held.alt);
  EXPECT_FALSE(keys[1].is_down);
}

TEST(SdlWindow, without_a_display_a_sentence_says_so) {
  SDL_setenv("SDL_VIDEODRIVER", "none of these", 1);
  try {
    SdlWindow window("test", 200, 100);
    FAIL();
  } catch (const InputError& error) {
    const std::string said = error.what();
    EXPECT_TRUE(said.starts_with("no window can be shown here: ")) << said;
    EXPECT_EQ(said.back(), '.') << said;
  }
}

}  // namespace
}  // namespace gradmesh
