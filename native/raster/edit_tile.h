#pragma once

#include <cstdint>
#include <vector>

#include "raster/painter.h"

namespace gradmesh {

// What an edit paints anew, as the shaders in egl/shaders read it: these structures consist of
// 32-bit numbers only and lie in memory as they do there (std430). Nothing here knows of a device.

/// A patch whose colours, and mostly its parameters too, are found by a shader.
struct TilePatch {
  /// As of Refinement and PatchColor, x before y, r before g: coefficient of u^i v^j at 4 i + j.
  float position[2][16];
  float color[4][16];
  /// Refinement::most, [a][b] at 4 a + b.
  float most[16];
  float start_u[3], start_v[3];
  float uu, uv, vv;
  /// The pixel from which `position` counts.
  std::int32_t x, y;
  /// What it is known by in a picture of the faces on top: its face's index + 1.
  std::uint32_t number;
  /// Which tile of a batch it is painted into.
  std::int32_t tile;
  std::uint32_t flags;

  static constexpr std::uint32_t bilinear = 1, opaque = 2, masked_opacity = 4;
};

/// Pixels of a row that a patch covers, in segments of `most_length` pixels (segments.h).
struct TileSpan {
  std::int32_t patch, y, x0, x1;
  /// The first segment that meets the tile, and how many segments the spans before have.
  std::int32_t first, segments_before;
  /// Where the parameters of its pixels begin, in pairs of u and v, or -1: they are to be found.
  std::int32_t parameters;
};

/// The pixels that an edit may change, and the patches there.
struct EditTile {
  Window window;
  /// Numbers of the faces that the edit touched, in rising order: what they painted is gone.
  std::vector<std::uint32_t> touched;
  std::vector<TilePatch> patches;
  std::vector<TileSpan> spans;
  /// Of patches that may fold, whose parameters are found here: u below 0 where not covered.
  std::vector<float> parameters;
  std::int32_t segments = 0;

  /// Empties it, without giving back memory.
  void reset(Window to);
};

/// Makes tiles. For one thread at a time; keeps its memory.
class EditTiler {
 public:
  /// What Painter::repaint would paint of `touched` and of what lies below them, in `within`;
  /// `painting` is what was painted before; null where no face lay over another.
  void make(const Mesh& mesh, const Frame& frame, const std::vector<Face>& touched, Window within,
            const Painting* painting, EditTile& tile);

  /// All faces, in `window`.
  void make_whole(const Mesh& mesh, const Frame& frame, Window window, EditTile& tile);

 private:
  void add_face(const Mesh& mesh, const Frame& frame, Face face, Window window, EditTile& tile);
  void add_traced(Window window, EditTile& tile) const;
  void add_found(Window window, EditTile& tile);

  Tessellator tessellator_;
  FaceShape shape_;
  Parameters parameters_;
};

}  // namespace gradmesh
