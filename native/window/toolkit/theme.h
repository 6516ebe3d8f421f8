#pragma once

struct ImFontAtlas;

namespace gradmesh {

/// Gives what Dear ImGui draws the colours of a dark or a light desktop, and sizes times `density`.
void set_theme(bool is_dark, float density);

/// Adds the letters of Europe's Latin alphabets, DejaVu Sans, as large as they are on an ordinary
/// screen times `density`.
void add_font(ImFontAtlas& fonts, float density);

}  // namespace gradmesh
