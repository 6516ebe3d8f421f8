#pragma once

#include <cstdint>
#include <vector>

#include "raster/painter.h"

namespace gradmesh {

// What an edit paints anew, as the shaders in device/shaders read it: these structures consist of
// 32-bit numbers only and lie in memory as in the shaders (std430). Nothing here knows of a device.

/// A patch whose colours, and mostly the parameters of its pixels too, are found by a shader.
struct TilePatch {
  /// Coefficients of u^i v^j at 4 i + j, as in Refinement (x, y) and PatchColor (r, g, b, a).
  float position[2][16];
  float color[4][16];
  /// Refinement::most, [a][b] at 4 a + b.
  float most[16];
  float start_u[3], start_v[3];
  /// The pixel from which `position` counts.
  std::int32_t x, y;
  /// The patch's number in a picture of the faces on top: its face's index + 1.
  std::uint32_t number;
  /// Index in the batch of the tile into which the patch is painted.
  std::int32_t tile;
  std::uint32_t flags;

  static constexpr std::uint32_t bilinear = 1, opaque = 2, masked_opacity = 4;
};

/// Pixels of a row that a patch covers, in segments of `most_length` pixels (segments.h).
struct TileSpan {
  std::int32_t patch, y, x0, x1;
  /// The first segment that meets the tile, and how many segments the spans before have.
  std::int32_t first, segments_before;
  /// Where the parameters of the span's pixels begin, in pairs of u and v, or -1 if the shader is
  /// to find them.
  std::int32_t parameters;
};

/// The pixels that an edit may change, and the patches there.
struct EditTile {
  Window window;
  /// Numbers of the faces that the edit touched, in rising order. The pixels that they painted are
  /// taken away.
  std::vector<std::uint32_t> touched;
  std::vector<TilePatch> patches;
  std::vector<TileSpan> spans;
  /// Parameters of the pixels of patches that may fold, which the processor finds; u is below 0
  /// where the pixel is not covered.
  std::vector<float> parameters;
  std::int32_t segments = 0;

  /// Empties the tile and sets its window, without giving back memory.
  void reset(Window to);
};

/// Makes tiles. Not thread-safe, as it keeps its memory from call to call.
class EditTiler {
 public:
  /// Makes the tile of what Painter::repaint would paint in `within`: the faces `touched` and the
  /// faces below them. `painting` is what was painted before, or null where no face lay over
  /// another.
  void make(const Mesh& mesh, const Frame& frame, const std::vector<Face>& touched, Window within,
            const Painting* painting, EditTile& tile);

  /// Makes the tile of all faces in `window`.
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
