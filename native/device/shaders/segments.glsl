// The patches of a batch, and the segments of the rows of pixels that they cover: a thread each.

layout(local_size_x = 64) in;

struct Patch {
  float position[32];
  float color[64];
  float most[16];
  float start_u[3], start_v[3];
  int x, y;
  uint number;
  int tile;
  uint flags;
};

struct Span {
  int patch_index, y, x0, x1;
  int first, segments_before;
  int parameters;
};

// Not `readonly`: of such a buffer Mesa 25's llvmpipe takes what a loop has loaded again after it,
// also for the threads that had left the loop before, which get 0.
layout(std430, binding = 1) buffer Patches { Patch patches[]; };
layout(std430, binding = 2) readonly buffer Spans { Span spans[]; };
// Pairs of u and v, u below 0 where a pixel is not covered.
layout(std430, binding = 3) readonly buffer Parameters { vec2 parameters[]; };

struct Segment {
  Span span;
  Tile tile;
  int k;         // of its span
  int start;     // its first pixel
  int from, to;  // its pixels inside the tile
};

FIND_OWNER(span_of_segment, spans, segments_before)

bool find_segment(out Segment segment) {
  int index = group_index() * int(gl_WorkGroupSize.x) + int(gl_LocalInvocationID.x);
  if (index >= count) return false;
  segment.span = spans[span_of_segment(index)];
  segment.tile = tiles[patches[segment.span.patch_index].tile];
  segment.k = segment.span.first + index - segment.span.segments_before;
  segment.start = segment.span.x0 + segment.k * MOST_LENGTH;
  segment.from = max(segment.start, segment.tile.x0);
  segment.to = min(segment.start + MOST_LENGTH, min(segment.span.x1, segment.tile.x1));
  return true;
}

// Parameters that were found already.
vec2 found_parameters(Segment segment, int x) {
  return parameters[segment.span.parameters + x - segment.span.x0];
}
