// What all shaders share: the tiles of a batch, and who works where. The structures are those of
// edit_tile.h and tile_painter.h.

struct Tile {
  int x0, y0, x1, y1;  // the pixels that may change
  int measured_x0, measured_y0, measured_x1, measured_y1;
  int pixels;  // where its pixels begin in the atlas
  int touched, touched_end;
  int paint_blocks, metric_blocks, metric_blocks_end;  // blocks of the tiles before, and with it
};

layout(std430, binding = 0) readonly buffer Tiles { Tile tiles[]; };

uniform int count;  // of what is worked on: tiles, blocks, segments
uniform ivec2 frame_size;

// Groups beyond the first so many are the next row of a dispatch.
const uint row_of_groups = 32768u;

int group_index() { return int(gl_WorkGroupID.y * row_of_groups + gl_WorkGroupID.x); }

// Defines a function that finds, in a list whose elements tell how many blocks or segments the ones
// before them have, the element that the one with an index belongs to.
#define FIND_OWNER(find, list, before)        \
  int find(int index) {                       \
    int low = 0, high = list.length() - 1;    \
    while (low < high) {                      \
      int middle = (low + high + 1) / 2;      \
      if (list[middle].before <= index)       \
        low = middle;                         \
      else                                    \
        high = middle - 1;                    \
    }                                         \
    return low;                               \
  }

bool is_inside(Tile tile, ivec2 p) {
  return p.x >= tile.x0 && p.x < tile.x1 && p.y >= tile.y0 && p.y < tile.y1;
}

int atlas_index(Tile tile, ivec2 p) {
  return tile.pixels + (p.y - tile.y0) * (tile.x1 - tile.x0) + p.x - tile.x0;
}

int frame_index(ivec2 p) { return p.y * frame_size.x + p.x; }

// Half a step up: levels 0 to 255.
uint to_level(float channel) { return uint(int(min(max(channel, 0.0), 255.0) + 0.5)); }

const uint white = 0xffffffu;
