// The pixels of the tiles before anything is painted: as they were, but for the faces that the
// edit touched.

layout(local_size_x = 16, local_size_y = 16) in;

layout(std430, binding = 1) readonly buffer FrameColors { uint frame_colors[]; };
layout(std430, binding = 2) readonly buffer FrameTops { uint frame_tops[]; };
layout(std430, binding = 3) readonly buffer Touched { uint touched[]; };
layout(std430, binding = 4) writeonly buffer Colors { uint colors[]; };
layout(std430, binding = 5) writeonly buffer Tops { uint tops[]; };

// Tiles without a frame below them begin white.
uniform bool begins_white;

FIND_OWNER(tile_of_block, tiles, paint_blocks)

bool is_touched(Tile tile, uint face) {
  int low = tile.touched, high = tile.touched_end;
  while (low < high) {
    int middle = (low + high) / 2;
    if (touched[middle] < face)
      low = middle + 1;
    else
      high = middle;
  }
  return low < tile.touched_end && touched[low] == face;
}

void main() {
  int block = group_index();
  if (block >= count) return;
  Tile tile = tiles[tile_of_block(block)];
  int blocks_a_row = (tile.x1 - tile.x0 + 15) / 16, in_tile = block - tile.paint_blocks;
  ivec2 p = ivec2(tile.x0, tile.y0) + 16 * ivec2(in_tile % blocks_a_row, in_tile / blocks_a_row) +
            ivec2(gl_LocalInvocationID.xy);
  if (!is_inside(tile, p)) return;
  int at = atlas_index(tile, p);
  uint top = begins_white ? 0u : frame_tops[frame_index(p)];
  bool is_gone = begins_white || is_touched(tile, top);
  tops[at] = is_gone ? 0u : top;
  colors[at] = is_gone ? white : frame_colors[frame_index(p)];
}
