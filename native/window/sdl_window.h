#pragma once

#include <functional>
#include <string>

#include "window/draw_lists.h"

struct ImGuiContext;
struct SDL_Window;
union SDL_Event;

namespace gradmesh {

/// A window of the desktop in which Dear ImGui draws; there is one at a time. It takes no graphics
/// processor, and while nothing happens it does nothing.
class SdlWindow {
 public:
  /// Opens a window of a size in pixels. Throws InputError where there is no display.
  SdlWindow(const std::string& title, int width, int height);
  SdlWindow(const SdlWindow&) = delete;
  ~SdlWindow();

  /// Draws with `frame`, which returns false once the window is to be closed, whenever a person has
  /// done something; and every tenth of a second as long as `is_busy` returns true. Returns when
  /// the window is closed either way.
  void run(const std::function<bool()>& frame, const std::function<bool()>& is_busy);

  /// Returns the pixels that the window has shown last. They may be another window's after run().
  Surface surface() const;

 private:
  /// Passes all events on that have come. Returns false if one closes the window.
  bool take_events();
  bool show(const std::function<bool()>& frame);

  SDL_Window* window_ = nullptr;
  ImGuiContext* context_ = nullptr;
  Texture font_;
};

/// Tells Dear ImGui what a person has done.
void pass_on(const SDL_Event& event);

}  // namespace gradmesh
