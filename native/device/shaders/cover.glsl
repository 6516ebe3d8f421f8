// Which face lies on top at each pixel: of those that cover it the last one, whoever comes first.

layout(std430, binding = 4) buffer Tops { uint tops[]; };

void main() {
  Segment segment;
  if (!find_segment(segment)) return;
  uint number = patches[segment.span.patch_index].number;
  int at = atlas_index(segment.tile, ivec2(segment.from, segment.span.y));
  for (int x = segment.from; x < segment.to; ++x, ++at)
    if (segment.span.parameters < 0 || found_parameters(segment, x).x >= 0.0)
      atomicMax(tops[at], number);
}
