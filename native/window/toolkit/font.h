#pragma once

struct ImFontAtlas;

namespace gradmesh {

/// Adds the letters of Europe's Latin alphabets, DejaVu Sans, as large as they are on an ordinary
/// screen times `density`.
void add_font(ImFontAtlas& fonts, float density);

}  // namespace gradmesh
