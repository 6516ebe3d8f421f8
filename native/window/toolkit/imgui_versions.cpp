#include "window/toolkit/imgui_versions.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace gradmesh {
namespace {

/// What Dear ImGui asks for by names of its own.
constexpr std::array<std::pair<ImGuiKey, SDL_Scancode>, 22> keys = {{
    {ImGuiKey_Tab, SDL_SCANCODE_TAB},
    {ImGuiKey_LeftArrow, SDL_SCANCODE_LEFT},
    {ImGuiKey_RightArrow, SDL_SCANCODE_RIGHT},
    {ImGuiKey_UpArrow, SDL_SCANCODE_UP},
    {ImGuiKey_DownArrow, SDL_SCANCODE_DOWN},
    {ImGuiKey_PageUp, SDL_SCANCODE_PAGEUP},
    {ImGuiKey_PageDown, SDL_SCANCODE_PAGEDOWN},
    {ImGuiKey_Home, SDL_SCANCODE_HOME},
    {ImGuiKey_End, SDL_SCANCODE_END},
    {ImGuiKey_Insert, SDL_SCANCODE_INSERT},
    {ImGuiKey_Delete, SDL_SCANCODE_DELETE},
    {ImGuiKey_Backspace, SDL_SCANCODE_BACKSPACE},
    {ImGuiKey_Space, SDL_SCANCODE_SPACE},
    {ImGuiKey_Enter, SDL_SCANCODE_RETURN},
    {ImGuiKey_Escape, SDL_SCANCODE_ESCAPE},
    {keypad_enter, SDL_SCANCODE_KP_ENTER},
    {ImGuiKey_A, SDL_SCANCODE_A},
    {ImGuiKey_C, SDL_SCANCODE_C},
    {ImGuiKey_V, SDL_SCANCODE_V},
    {ImGuiKey_X, SDL_SCANCODE_X},
    {ImGuiKey_Y, SDL_SCANCODE_Y},
    {ImGuiKey_Z, SDL_SCANCODE_Z},
}};

}  // namespace

#if IMGUI_VERSION_NUM < 18700

void set_up_input(ImGuiIO& io) {
  for (const auto& [key, code] : keys) io.KeyMap[key] = code;
}

void add_key(ImGuiIO& io, SDL_Scancode code, bool is_down) {
  if (std::size_t(code) < std::size(io.KeysDown)) io.KeysDown[code] = is_down;
}

void add_modifiers(ImGuiIO& io, SDL_Keymod held) {
  io.KeyCtrl = (held & KMOD_CTRL) != 0;
  io.KeyShift = (held & KMOD_SHIFT) != 0;
  io.KeyAlt = (held & KMOD_ALT) != 0;
  io.KeySuper = (held & KMOD_GUI) != 0;
}

void release_keys(ImGuiIO& io) {
  std::ranges::fill(io.KeysDown, false);
  add_modifiers(io, KMOD_NONE);
}

void add_pointer(ImGuiIO& io, float x, float y) { io.MousePos = {x, y}; }

void add_button(ImGuiIO& io, ImGuiMouseButton button, bool is_down) {
  io.MouseDown[button] = is_down;
}

void add_wheel(ImGuiIO& io, float x, float y) {
  io.MouseWheelH += x;
  io.MouseWheel += y;
}

bool is_held_down(ImGuiKey key) { return ImGui::IsKeyDown(ImGui::GetKeyIndex(key)); }

#else

void set_up_input(ImGuiIO& io) {
  // All that has happened counts in the next frame, as it does where members are set: a window that
  // waits for the next event would else show the last ones late.
  io.ConfigInputTrickleEventQueue = false;
}

void add_key(ImGuiIO& io, SDL_Scancode code, bool is_down) {
  const auto found = std::ranges::find(keys, code, &std::pair<ImGuiKey, SDL_Scancode>::second);
  if (found != keys.end()) io.AddKeyEvent(found->first, is_down);
}

void add_modifiers(ImGuiIO& io, SDL_Keymod held) {
  io.AddKeyEvent(ImGuiMod_Ctrl, (held & KMOD_CTRL) != 0);
  io.AddKeyEvent(ImGuiMod_Shift, (held & KMOD_SHIFT) != 0);
  io.AddKeyEvent(ImGuiMod_Alt, (held & KMOD_ALT) != 0);
  io.AddKeyEvent(ImGuiMod_Super, (held & KMOD_GUI) != 0);
}

void release_keys(ImGuiIO& io) {
  for (const auto& each : keys) io.AddKeyEvent(each.first, false);
  add_modifiers(io, KMOD_NONE);
}

void add_pointer(ImGuiIO& io, float x, float y) { io.AddMousePosEvent(x, y); }

void add_button(ImGuiIO& io, ImGuiMouseButton button, bool is_down) {
  io.AddMouseButtonEvent(button, is_down);
}

void add_wheel(ImGuiIO& io, float x, float y) { io.AddMouseWheelEvent(x, y); }

bool is_held_down(ImGuiKey key) { return ImGui::IsKeyDown(key); }

#endif

ImTextureID texture_id(const Texture& texture) {
  return ImTextureID(reinterpret_cast<std::uintptr_t>(&texture));
}

const Texture* texture_of(const ImDrawCmd& command) {
  return reinterpret_cast<const Texture*>(std::uintptr_t(command.GetTexID()));
}

}  // namespace gradmesh
