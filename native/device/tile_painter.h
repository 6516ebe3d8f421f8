#pragma once

#include <cstdint>
#include <vector>

#include "device/use.h"
#include "raster/edit_tile.h"

namespace gradmesh {

/// A tile among others in the atlas of a batch, as shaders/tiles.glsl reads it.
struct AtlasTile {
  Window window;    ///< the pixels that may change
  Window measured;  ///< those whose distances may change
  std::int32_t pixels;
  std::int32_t touched, touched_end;
  std::int32_t paint_blocks, metric_blocks, metric_blocks_end;
};

/// Tiles side by side in one atlas, and the patches that are painted into them.
struct Atlas {
  std::vector<AtlasTile> tiles;
  std::vector<std::uint32_t> touched;
  std::vector<TilePatch> patches;
  std::vector<TileSpan> spans;
  std::vector<float> parameters;
  std::int32_t pixels = 0, segments = 0, paint_blocks = 0, metric_blocks = 0;

  void clear();
  /// Adds a tile. `measured` is clipped to the frame, and empty if nothing is to be measured.
  void add(const EditTile& tile, Window measured);
};

/// The picture that edits start from, on the device.
struct FrameImage {
  int width = 0, height = 0;
  /// For each pixel the colour as r + 256 g + 65536 b, and the number of the face on top
  /// (TilePatch), or `hidden_number` where the pixel stays white whatever covers it.
  Buffer colors, tops;

  static constexpr std::uint32_t hidden_number = 0xffffffff;
  void set(const Frame& frame, const Painting& painting);
  void set(const Image& image);
};

/// Paints the tiles of an atlas with compute shaders: the pixels that the software path would
/// paint, by the same rule on the same outlines, and the same colours.
class TilePainter {
 public:
  explicit TilePainter(const Device::Use& use);

  /// Paints the tiles over the picture. If `picture` is null the tiles begin white, with nothing on
  /// top.
  void paint(const Atlas& atlas, const FrameImage* picture);

  const Buffer& tiles() const { return tiles_; }
  /// Returns the colours of the atlas, as in FrameImage.
  const Buffer& colors() const { return colors_; }

 private:
  const Program &clear_, &cover_, &shade_;
  Buffer tiles_, touched_, patches_, spans_, parameters_, tops_, colors_, bases_;
};

/// Returns r + 256 g + 65536 b for each pixel of an image.
std::vector<std::uint32_t> packed(const Image& image);

/// Returns the source that the shaders share (shaders/tiles.glsl).
std::string tiles_source();

}  // namespace gradmesh
