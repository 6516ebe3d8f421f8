#pragma once

#include <SDL.h>
#include <imgui.h>

namespace gradmesh {

struct Texture;

/// What differs between the versions of Dear ImGui from 1.86 to 1.92. Until 1.86 a program sets
/// what is pressed; since 1.87 it adds events. The key of the keypad was renamed in 1.87. A texture
/// is a pointer until 1.91.3, a number since.

#if IMGUI_VERSION_NUM < 18700
inline constexpr ImGuiKey keypad_enter = ImGuiKey_KeyPadEnter;
#else
inline constexpr ImGuiKey keypad_enter = ImGuiKey_KeypadEnter;
#endif

/// Prepares Dear ImGui for the functions below. Must be called once, before the first frame.
void set_up_input(ImGuiIO& io);

/// Tells that a key of the keyboard was pressed or let go. Keys that Dear ImGui has no use for are
/// left out.
void add_key(ImGuiIO& io, SDL_Scancode code, bool is_down);
/// Tells which modifiers are held down, of SDL's KMOD_CTRL, KMOD_SHIFT, KMOD_ALT and KMOD_GUI.
void add_modifiers(ImGuiIO& io, SDL_Keymod held);
/// Tells that all keys were let go.
void release_keys(ImGuiIO& io);
/// Tells where the pointer is, in pixels of the window; -FLT_MAX twice if it is outside.
void add_pointer(ImGuiIO& io, float x, float y);
void add_button(ImGuiIO& io, ImGuiMouseButton button, bool is_down);
void add_wheel(ImGuiIO& io, float x, float y);

/// Returns true while a key is held down that set_up_input() knows.
bool is_held_down(ImGuiKey key);

/// Returns how draw lists name a picture, which must stay where it is while they do.
ImTextureID texture_id(const Texture& texture);
/// Returns the picture of a command of a draw list; null if it has none.
const Texture* texture_of(const ImDrawCmd& command);

}  // namespace gradmesh
