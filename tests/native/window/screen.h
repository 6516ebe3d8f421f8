#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "window/toolkit/draw_lists.h"
#include "window/toolkit/imgui_versions.h"
#include "window/toolkit/theme.h"
#include "window/view/eye_window.h"

namespace gradmesh::test {

/// A person at a window that nobody shows: what they do is told to it, and its pixels can be read.
class Screen {
 public:
  Screen(Eye& eye, int width, int height, Translation translation, bool is_dark = false,
         float density = 1)
      : context_(ImGui::CreateContext()),
        window_(eye, std::move(translation), is_dark),
        pixels_(std::size_t(width) * std::size_t(height)),
        surface_{width, height, width, pixels_.data()} {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {float(width), float(height)};
    set_up_input(io);
    add_pointer(io, -FLT_MAX, -FLT_MAX);
    add_font(*io.Fonts, density);
    eye.density = density;
    unsigned char* opacity = nullptr;
    io.Fonts->GetTexDataAsAlpha8(&opacity, &font_.width, &font_.height);
    font_.opacity = opacity;
    io.Fonts->SetTexID(texture_id(font_));
    settle();
  }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;
  ~Screen() { ImGui::DestroyContext(context_); }

  /// Draws a frame. Returns false once the window is closed.
  bool frame(const Happened& happened = {}) {
    ImGui::GetIO().DeltaTime = 1 / 60.0F;
    ImGui::NewFrame();
    is_open_ = window_.show(happened) && is_open_;
    ImGui::Render();
    std::fill(pixels_.begin(), pixels_.end(), 0u);
    paint(*ImGui::GetDrawData(), surface_);
    return is_open_;
  }
  void settle() {
    for (int i = 0; i < 3; ++i) frame();
  }

  void move(glm::dvec2 to) {
    add_pointer(ImGui::GetIO(), float(to.x), float(to.y));
    frame();
  }
  void hold(bool is_down, int button = ImGuiMouseButton_Left) {
    add_button(ImGui::GetIO(), button, is_down);
    frame();
  }
  void click(glm::dvec2 at) {
    move(at);
    hold(true);
    hold(false);
    settle();
  }
  /// Clicks what has this English label. Returns false if it is not there.
  bool click(const std::string& label) {
    const auto at = window_.ui().place_of(label);
    if (at) click(*at);
    return at.has_value();
  }
  void drag(const std::vector<glm::dvec2>& way) {
    move(way.front());
    hold(true);
    for (const glm::dvec2 to : way) move(to);
    hold(false);
    settle();
  }
  void key(const std::string& name, Held held = {}) {
    frame({{{name, true, held}}, false});
    frame({{{name, false, held}}, false});
    settle();
  }
  void turn_wheel(float steps, Held held = {}) {
    ImGuiIO& io = ImGui::GetIO();
    add_modifiers(io, SDL_Keymod((held.control ? KMOD_CTRL : 0) | (held.shift ? KMOD_SHIFT : 0)));
    add_wheel(io, 0, steps);
    frame();
    add_modifiers(io, KMOD_NONE);
    settle();
  }

  const EyeWindow& window() const { return window_; }
  bool is_open() const { return is_open_; }
  const Surface& surface() const { return surface_; }
  std::uint32_t pixel(int x, int y) const {
    return pixels_[std::size_t(y) * std::size_t(surface_.width) + std::size_t(x)];
  }

 private:
  ImGuiContext* context_;
  Texture font_;
  EyeWindow window_;
  std::vector<std::uint32_t> pixels_;
  Surface surface_;
  bool is_open_ = true;
};

}  // namespace gradmesh::test
