// The sum of a tile's blocks, always in the same order.

layout(local_size_x = 64) in;

layout(std430, binding = 1) readonly buffer Rises { float rises[]; };
layout(std430, binding = 2) writeonly buffer Totals { float totals[]; };

shared float sums[64];

void main() {
  int index = group_index();
  if (index >= count) return;
  int self = int(gl_LocalInvocationIndex);
  float sum = 0.0;
  for (int block = tiles[index].metric_blocks + self; block < tiles[index].metric_blocks_end;
       block += 64)
    sum += rises[block];
  sums[self] = sum;
  barrier();
  for (int half_size = 32; half_size > 0; half_size /= 2) {
    if (self < half_size) sums[self] += sums[self + half_size];
    barrier();
  }
  if (self == 0) totals[index] = sums[0];
}
