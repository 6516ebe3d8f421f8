#pragma once

namespace gradmesh {

/// Gives what Dear ImGui draws the colours of a dark or a light desktop, and sizes times `density`.
void set_theme(bool is_dark, float density);

}  // namespace gradmesh
