#pragma once

#include <imgui.h>

#include <cstdint>

namespace gradmesh {

/// A picture that draw lists show (texture_id() in imgui_versions.h).
struct Texture {
  int width = 0, height = 0;
  /// How opaque the colour of a drawing is at each pixel, row by row, as the letters of a font have
  /// it; null if `colors` has the pixels.
  const std::uint8_t* opacity = nullptr;
  /// Opaque pixels, 0x00rrggbb.
  const std::uint32_t* colors = nullptr;
};

/// The pixels of a window, 0x00rrggbb, whose rows begin `stride` pixels apart.
struct Surface {
  int width = 0, height = 0, stride = 0;
  std::uint32_t* pixels = nullptr;
};

/// Paints what Dear ImGui has drawn over the pixels of a surface. A pixel belongs to a triangle if
/// its centre does; of two triangles that meet in a side, to one of them, so that what is
/// translucent has no seams. The same lists give the same pixels on every machine.
void paint(const ImDrawData& data, const Surface& surface);

}  // namespace gradmesh
