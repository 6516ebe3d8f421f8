#pragma once

#include <functional>
#include <string>
#include <vector>

#include "window/toolkit/draw_lists.h"
#include "window/toolkit/owner.h"

struct ImGuiContext;
struct SDL_Window;
union SDL_Event;

namespace gradmesh {

/// What is held down beside a key or a button.
struct Held {
  bool control = false, shift = false, alt = false;

  bool operator==(const Held&) const = default;
};

/// A key that was pressed or let go.
struct Key {
  /// As SDL_GetKeyName() has it: "A", "Left", "Return", "Keypad +".
  std::string name;
  bool is_down = true;
  Held held = {};
};

/// What has happened since the last frame and Dear ImGui does not know.
struct Happened {
  std::vector<Key> keys = {};
  /// A person wants the window to close.
  bool must_close = false;
};

/// A window of the desktop in which Dear ImGui draws; there is one at a time. It takes no graphics
/// processor, and while nothing happens it does nothing.
class SdlWindow {
 public:
  /// Opens a window of a size in pixels of an ordinary screen, or one that is as large as the
  /// screen allows; in front of the window of another program that is named
  /// (give_to). Throws InputError where there is no display.
  SdlWindow(const std::string& title, int width, int height, const OwnerTitle& owner = {});
  SdlWindow(const SdlWindow&) = delete;
  ~SdlWindow();

  /// Draws a frame. Returns false once the window is to be closed.
  using Frame = std::function<bool(const Happened&)>;

  /// Draws with `frame` whenever a person has done something, and every tenth of a second as long
  /// as `is_busy` returns true. Returns when `frame` has returned false.
  void run(const Frame& frame, const std::function<bool()>& is_busy);

  /// Returns how many pixels the screen has for each of an ordinary one.
  float density() const { return density_; }
  /// Return how large the window is, in pixels of an ordinary screen.
  int width() const { return in_ordinary_pixels(surface().width); }
  int height() const { return in_ordinary_pixels(surface().height); }

  /// Returns the pixels that the window has shown last. They may be another window's after run().
  Surface surface() const;

 private:
  int in_ordinary_pixels(int length) const;
  /// Passes all events on that have come.
  Happened take_events();
  bool show(const Frame& frame, const Happened& happened);

  SDL_Window* window_ = nullptr;
  ImGuiContext* context_ = nullptr;
  float density_ = 1;
  Texture font_;
};

/// Tells Dear ImGui what a person has done.
void pass_on(const SDL_Event& event);

}  // namespace gradmesh
