#include "window/toolkit/sdl_window.h"

#include <SDL.h>
#include <imgui.h>

#include <algorithm>
#include <climits>
#include <cmath>

#include "base/error.h"
#include "window/toolkit/desktop.h"
#include "window/toolkit/imgui_versions.h"
#include "window/toolkit/theme.h"

namespace gradmesh {
namespace {

void set_up(ImGuiIO& io, Texture& font, float density) {
  // Nothing is written beside the document.
  io.IniFilename = nullptr;
  add_font(*io.Fonts, density);
  io.BackendPlatformName = "gradmesh";
  set_up_input(io);
  unsigned char* opacity = nullptr;
  io.Fonts->GetTexDataAsAlpha8(&opacity, &font.width, &font.height);
  font.opacity = opacity;
  io.Fonts->SetTexID(texture_id(font));
}

/// Returns which of Dear ImGui's buttons a button of the mouse is; -1 for others.
int button_of(Uint8 button) {
  if (button == SDL_BUTTON_LEFT) return ImGuiMouseButton_Left;
  if (button == SDL_BUTTON_RIGHT) return ImGuiMouseButton_Right;
  if (button == SDL_BUTTON_MIDDLE) return ImGuiMouseButton_Middle;
  return -1;
}

/// The least size, in pixels of an ordinary screen, in which all that is said can be read.
constexpr double least_width = 720, least_height = 540;

/// Returns the width and height that a window may have.
std::pair<int, int> room_on_the_screen() {
  // What a window manager draws around a window.
  constexpr int frame = 8, title = 40;
  SDL_Rect room{};
  if (SDL_GetDisplayUsableBounds(0, &room) != 0) return {INT_MAX, INT_MAX};
  return {room.w - frame, room.h - title};
}

/// Opens a window, and finds the density of its screen; null where that fails.
SDL_Window* open_window(const std::string& title, int width, int height, const OwnerTitle& owner,
                        float& density) {
  // It is seen once it has its size, for which the screen has to be known.
  SDL_Window* const window =
      SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width, height,
                       SDL_WINDOW_RESIZABLE | SDL_WINDOW_HIDDEN);
  if (!window) return nullptr;
  density = density_of(window);
  const auto [most_width, most_height] = room_on_the_screen();
  SDL_SetWindowSize(window, std::min(int(std::lround(float(width) * density)), most_width),
                    std::min(int(std::lround(float(height) * density)), most_height));
  SDL_SetWindowMinimumSize(window, std::min(int(std::lround(least_width * density)), most_width),
                           std::min(int(std::lround(least_height * density)), most_height));
  SDL_SetWindowPosition(window, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED);
  give_to(window, owner);
  SDL_ShowWindow(window);
  return window;
}

Held held_with(const SDL_KeyboardEvent& key) {
  const SDL_Keymod held = SDL_Keymod(key.keysym.mod);
  return {(held & KMOD_CTRL) != 0, (held & KMOD_SHIFT) != 0, (held & KMOD_ALT) != 0};
}

Key key_of(const SDL_KeyboardEvent& key) {
  return {SDL_GetKeyName(key.keysym.sym), key.type == SDL_KEYDOWN, held_with(key)};
}

}  // namespace

void pass_on(const SDL_Event& event) {
  ImGuiIO& io = ImGui::GetIO();
  switch (event.type) {
    case SDL_MOUSEMOTION:
      add_pointer(io, float(event.motion.x), float(event.motion.y));
      break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
      add_pointer(io, float(event.button.x), float(event.button.y));
      if (const int button = button_of(event.button.button); button >= 0)
        add_button(io, button, event.type == SDL_MOUSEBUTTONDOWN);
      break;
    case SDL_MOUSEWHEEL:
      add_wheel(io, event.wheel.preciseX, event.wheel.preciseY);
      break;
    case SDL_TEXTINPUT:
      io.AddInputCharactersUTF8(event.text.text);
      break;
    case SDL_KEYDOWN:
    case SDL_KEYUP:
      add_modifiers(io, SDL_Keymod(event.key.keysym.mod));
      add_key(io, event.key.keysym.scancode, event.type == SDL_KEYDOWN);
      break;
    case SDL_WINDOWEVENT:
      if (event.window.event == SDL_WINDOWEVENT_LEAVE) add_pointer(io, -FLT_MAX, -FLT_MAX);
      if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) release_keys(io);
      break;
    default:
      break;
  }
}

SdlWindow::SdlWindow(const std::string& title, int width, int height, const OwnerTitle& owner) {
  SDL_SetMainReady();
  // Software drawing through a graphics library takes longer than without one.
  SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
  SDL_SetHint(SDL_HINT_WINDOWS_DPI_AWARENESS, "permonitorv2");
  // A window of a document is no video: the screen may go dark meanwhile.
  SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
  if (SDL_Init(SDL_INIT_VIDEO) == 0) window_ = open_window(title, width, height, owner, density_);
  const SDL_Surface* const pixels = window_ ? SDL_GetWindowSurface(window_) : nullptr;
  const bool is_usual = pixels && pixels->format->BytesPerPixel == 4 &&
                        pixels->format->Rmask == 0xff0000 && pixels->format->Bmask == 0xff;
  if (!is_usual) {
    const std::string why = pixels ? "the screen has unusual pixels" : SDL_GetError();
    if (window_) SDL_DestroyWindow(window_);
    SDL_Quit();
    throw InputError("no window can be shown here: {0}.", why);
  }
  context_ = ImGui::CreateContext();
  set_up(ImGui::GetIO(), font_, density_);
}

SdlWindow::~SdlWindow() {
  ImGui::DestroyContext(context_);
  SDL_DestroyWindow(window_);
  SDL_Quit();
}

int SdlWindow::in_ordinary_pixels(int length) const {
  return int(std::lround(float(length) / density_));
}

Surface SdlWindow::surface() const {
  const SDL_Surface* const s = SDL_GetWindowSurface(window_);
  return {s->w, s->h, s->pitch / 4, static_cast<std::uint32_t*>(s->pixels)};
}

Happened SdlWindow::take_events() {
  Happened happened;
  SDL_Event event;
  while (SDL_PollEvent(&event)) {
    pass_on(event);
    if (event.type == SDL_QUIT) happened.must_close = true;
    if (event.type == SDL_KEYDOWN || event.type == SDL_KEYUP)
      happened.keys.push_back(key_of(event.key));
    // A button that is pressed and released between two frames would not be seen.
    if (event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEBUTTONUP) break;
  }
  return happened;
}

bool SdlWindow::show(const Frame& frame, const Happened& happened) {
  const Surface pixels = surface();
  for (int y = 0; y < pixels.height; ++y)
    std::fill_n(pixels.pixels + std::ptrdiff_t(y) * pixels.stride, pixels.width, 0u);
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {float(pixels.width), float(pixels.height)};
  io.DeltaTime = 1 / 60.0F;
  ImGui::NewFrame();
  const bool goes_on = frame(happened);
  ImGui::Render();
  paint(*ImGui::GetDrawData(), pixels);
  SDL_UpdateWindowSurface(window_);
  return goes_on;
}

void SdlWindow::run(const Frame& frame, const std::function<bool()>& is_busy) {
  // What is drawn settles some frames after what a person does.
  constexpr int frames_to_settle = 3, a_tenth_of_a_second = 100;
  for (int left = frames_to_settle; show(frame, take_events());) {
    if (left-- > 0) continue;
    is_busy() ? SDL_WaitEventTimeout(nullptr, a_tenth_of_a_second) : SDL_WaitEvent(nullptr);
    left = frames_to_settle;
  }
}

}  // namespace gradmesh
