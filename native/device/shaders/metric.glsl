// What both metrics share. A group works on 16 x 16 pixels of a tile: it reads them and what lies
// within REACH around them, and every thread finds the distance at one pixel. What is written is
// chosen by PASS:
//   RISES      the sum of what the edit changes in the distances of these pixels
//   DISTANCES  the distances of the frame, before any edit
//   REFERENCE  what is known of the reference image alone

layout(local_size_x = 16, local_size_y = 16) in;

const int side = 16, around = side + 2 * REACH, threads = side * side;

layout(std430, binding = 1) readonly buffer FrameColors { uint frame_colors[]; };
layout(std430, binding = 2) readonly buffer Colors { uint colors[]; };
layout(std430, binding = 3) buffer Reference { float reference[]; };
layout(std430, binding = 4) buffer Distances { float distances[]; };
layout(std430, binding = 5) writeonly buffer Rises { float rises[]; };

// Samples in a plane of the reference.
uniform int plane_size;

shared uint any_difference;

FIND_OWNER(tile_of_block, tiles, metric_blocks)

ivec2 block_corner(Tile tile, int block) {
  int blocks_a_row = (tile.measured_x1 - tile.measured_x0 + side - 1) / side;
  int in_tile = block - tile.metric_blocks;
  return ivec2(tile.measured_x0, tile.measured_y0) +
         side * ivec2(in_tile % blocks_a_row, in_tile / blocks_a_row);
}

bool is_measured(Tile tile, ivec2 p) { return p.x < tile.measured_x1 && p.y < tile.measured_y1; }

// The pixel beyond the frame is the nearest one inside.
ivec2 in_frame(ivec2 p) { return clamp(p, ivec2(0), frame_size - 1); }

uint color_of(Tile tile, ivec2 p) {
  return is_inside(tile, p) ? colors[atlas_index(tile, p)] : frame_colors[frame_index(p)];
}

vec3 levels(uint color) { return vec3(color & 255u, (color >> 8) & 255u, (color >> 16) & 255u); }

// The i-th of the pixels within reach of the block, row by row.
ivec2 pixel_around(ivec2 corner, int i) {
  return in_frame(corner - REACH + ivec2(i % around, i / around));
}

#if PASS == RISES
shared float sums[threads];

// Whether the edit changes any pixel within reach of the block: the same for all its threads.
bool differs(Tile tile, ivec2 corner) {
  if (gl_LocalInvocationIndex == 0u) any_difference = 0u;
  barrier();
  bool is_other = false;
  for (int i = int(gl_LocalInvocationIndex); i < around * around; i += threads) {
    ivec2 p = pixel_around(corner, i);
    if (is_inside(tile, p) && colors[atlas_index(tile, p)] != frame_colors[frame_index(p)])
      is_other = true;
  }
  if (is_other) atomicOr(any_difference, 1u);
  barrier();
  return any_difference != 0u;
}

// Always in the same order.
void write_sum(int block, float rise) {
  int self = int(gl_LocalInvocationIndex);
  sums[self] = rise;
  barrier();
  for (int half_size = threads / 2; half_size > 0; half_size /= 2) {
    if (self < half_size) sums[self] += sums[self + half_size];
    barrier();
  }
  if (self == 0) rises[block] = sums[0];
}
#endif

// Finds what PASS asks for at pixel p of a block.
void measure(int block, Tile tile, ivec2 corner, ivec2 p);

void main() {
  int block = group_index();
  if (block >= count) return;
  Tile tile = tiles[tile_of_block(block)];
  ivec2 corner = block_corner(tile, block);
#if PASS == RISES
  if (!differs(tile, corner)) {
    if (gl_LocalInvocationIndex == 0u) rises[block] = 0.0;
    return;
  }
#endif
  measure(block, tile, corner, corner + ivec2(gl_LocalInvocationID.xy));
}

void write_distance(int block, Tile tile, ivec2 p, float distance) {
#if PASS == DISTANCES
  if (is_measured(tile, p)) distances[frame_index(p)] = distance;
#elif PASS == RISES
  write_sum(block, is_measured(tile, p) ? distance - distances[frame_index(p)] : 0.0);
#endif
}
