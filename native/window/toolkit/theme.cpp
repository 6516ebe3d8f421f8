#include "window/toolkit/theme.h"

#include <imgui.h>

#include "dejavu_sans.h"

namespace gradmesh {
namespace {

ImVec4 gray(float level, float opacity = 1) { return {level, level, level, opacity}; }

void set_colors(ImVec4* colors, bool is_dark) {
  const ImVec4 accent = is_dark ? ImVec4(0.22F, 0.50F, 0.80F, 1) : ImVec4(0.62F, 0.80F, 0.97F, 1);
  const ImVec4 bright = is_dark ? ImVec4(0.30F, 0.60F, 0.92F, 1) : ImVec4(0.50F, 0.72F, 0.95F, 1);
  colors[ImGuiCol_WindowBg] = gray(is_dark ? 0.17F : 0.95F);
  colors[ImGuiCol_PopupBg] = gray(is_dark ? 0.11F : 1.0F);
  colors[ImGuiCol_Border] = gray(is_dark ? 0.32F : 0.72F);
  colors[ImGuiCol_FrameBg] = gray(is_dark ? 0.11F : 1.0F);
  colors[ImGuiCol_FrameBgHovered] = gray(is_dark ? 0.24F : 0.88F);
  colors[ImGuiCol_Button] = gray(is_dark ? 0.27F : 0.86F);
  colors[ImGuiCol_ButtonHovered] = gray(is_dark ? 0.35F : 0.80F);
  colors[ImGuiCol_FrameBgActive] = colors[ImGuiCol_ButtonActive] = accent;
  colors[ImGuiCol_Header] = colors[ImGuiCol_HeaderActive] = accent;
  colors[ImGuiCol_HeaderHovered] = bright;
  colors[ImGuiCol_CheckMark] = colors[ImGuiCol_SliderGrab] = colors[ImGuiCol_PlotLines] =
      is_dark ? bright : ImVec4(0.0F, 0.36F, 0.72F, 1);
  colors[ImGuiCol_TextDisabled] = gray(0.5F);
}

}  // namespace

void set_theme(bool is_dark, float density) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  is_dark ? ImGui::StyleColorsDark(&style) : ImGui::StyleColorsLight(&style);
  set_colors(style.Colors, is_dark);
  style.WindowPadding = {12, 10};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {6, 6};
  style.FrameRounding = style.GrabRounding = style.PopupRounding = 3;
  style.FrameBorderSize = is_dark ? 0.0F : 1.0F;
  style.WindowBorderSize = 0;
  style.ScaleAllSizes(density);
}

void add_font(ImFontAtlas& fonts, float density) {
  constexpr float pixels = 15;
  // Latin to its extended letters, then what of punctuation, arrows and signs the font has.
  static constexpr ImWchar ranges[] = {0x20,   0x17f,  0x2013, 0x203a, 0x2190,
                                       0x2193, 0x21b6, 0x21b7, 0x2212, 0x2212,
                                       0x25b6, 0x25c0, 0x2713, 0x2713, 0};
  ImFontConfig config;
  // The atlas reads the letters, and never frees them.
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = config.OversampleV = 2;
  fonts.AddFontFromMemoryTTF(const_cast<unsigned char*>(dejavu::DejaVuSans_Latin_ttf),
                             int(sizeof dejavu::DejaVuSans_Latin_ttf), density * pixels, &config,
                             ranges);
}

}  // namespace gradmesh
