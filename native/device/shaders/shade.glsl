// The colours of the pixels of a segment, where its patch lies on top. The same arithmetic in the
// same order as the software path's (newton-inl.h, invert.cpp, fill.cpp), which says why.

layout(std430, binding = 4) readonly buffer Tops { uint tops[]; };
layout(std430, binding = 5) writeonly buffer Colors { uint colors[]; };
// hermite_bases, then linear_bases of segments.h.
layout(std430, binding = 6) readonly buffer Bases { float bases[]; };

struct Derivatives {
  float value, along_u, along_v;
};

Derivatives derivatives(int p, int first, float u, float v) {
  precise float row[4], slope[4];
  for (int i = 0; i < 4; ++i) {
    int c = first + 4 * i;
    float c1 = patches[p].position[c + 1], c2 = patches[p].position[c + 2],
          c3 = patches[p].position[c + 3];
    precise float a = c2 + v * c3;
    precise float b = c1 + v * a;
    row[i] = patches[p].position[c] + v * b;
    slope[i] = b + v * (a + v * c3);
  }
  precise float a = row[2] + u * row[3];
  precise float b = row[1] + u * a;
  precise float value = row[0] + u * b;
  precise float along_u = b + u * (a + u * row[3]);
  precise float along_v = slope[0] + u * (slope[1] + u * (slope[2] + u * slope[3]));
  return Derivatives(value, along_u, along_v);
}

struct Position {
  Derivatives x, y;
  float determinant;
};

Position position(int p, vec2 at) {
  Derivatives x = derivatives(p, 0, at.x, at.y), y = derivatives(p, 16, at.x, at.y);
  precise float determinant = x.along_u * y.along_v - x.along_v * y.along_u;
  return Position(x, y, determinant);
}

float closest(float dx, float dy, float along_x, float along_y, float other, float other_x,
              float other_y) {
  precise float x = dx - other * other_x;
  precise float y = dy - other * other_y;
  precise float result = (x * along_x + y * along_y) / (along_x * along_x + along_y * along_y);
  return result;
}

vec2 clamp01(vec2 at) { return min(max(at, vec2(0.0)), vec2(1.0)); }

// A step of Newton's method towards the pixel, not out of the patch. Returns the step as it would
// be without that.
vec2 approach(Position at, vec2 pixel, inout vec2 uv) {
  precise float dx = pixel.x - at.x.value;
  precise float dy = pixel.y - at.y.value;
  precise vec2 step = vec2((dx * at.y.along_v - dy * at.x.along_v) / at.determinant,
                           (dy * at.x.along_u - dx * at.y.along_u) / at.determinant);
  precise vec2 free = uv + step;
  vec2 next = clamp01(free);
  bvec2 is_out = notEqual(next, free);
  if (is_out.x) {
    precise float v =
        uv.y + closest(dx, dy, at.x.along_v, at.y.along_v, next.x - uv.x, at.x.along_u, at.y.along_u);
    next.y = min(max(v, 0.0), 1.0);
  }
  if (is_out.y) {
    precise float u =
        uv.x + closest(dx, dy, at.x.along_u, at.y.along_u, next.y - uv.y, at.x.along_v, at.y.along_v);
    next.x = min(max(u, 0.0), 1.0);
  }
  uv = next;
  return step;
}

struct Knot {
  vec2 uv;
  vec2 slope;  // of u and v along the row, by pixel
  bool is_lost;
};

float most(int p, int a, int b) { return patches[p].most[4 * a + b]; }

bool solve(int p, vec2 pixel, inout Knot knot) {
  float uu = most(p, 2, 0), uv = most(p, 1, 1), vv = most(p, 0, 2);
  for (int n = 0; n < MOST_KNOT_STEPS; ++n) {
    Position at = position(p, knot.uv);
    vec2 step = abs(approach(at, pixel, knot.uv));
    knot.slope = vec2(at.y.along_v / at.determinant, -(at.y.along_u / at.determinant));
    precise float of_u = uu * step.x + uv * step.y;
    precise float of_v = uv * step.x + vv * step.y;
    precise float off = of_u * abs(knot.slope.x) + of_v * abs(knot.slope.y);
    precise float left = of_u * step.x + of_v * step.y;
    if (off <= SLOPE_ERROR && left <= 2.0 * KNOT_ERROR) return true;
  }
  return false;
}

vec2 nearest_start(int p, vec2 pixel, vec2 otherwise) {
  float least = 1e30;
  vec2 nearest = otherwise;
  for (int i = 0; i <= START_CELLS; ++i)
    for (int j = 0; j <= START_CELLS; ++j) {
      vec2 here = vec2(i, j) / float(START_CELLS);
      Position at = position(p, here);
      precise float dx = pixel.x - at.x.value;
      precise float dy = pixel.y - at.y.value;
      precise float distance = dx * dx + dy * dy;
      if (distance < least) {
        least = distance;
        nearest = here;
      }
    }
  return nearest;
}

float plane(float at_zero, float by_x, float by_y, vec2 pixel) {
  precise float value = at_zero + (pixel.x * by_x + pixel.y * by_y);
  return min(max(value, 0.0), 1.0);
}

Knot find_knot(int p, vec2 pixel) {
  Knot knot;
  knot.uv = vec2(
      plane(patches[p].start_u[0], patches[p].start_u[1], patches[p].start_u[2], pixel),
      plane(patches[p].start_v[0], patches[p].start_v[1], patches[p].start_v[2], pixel));
  knot.slope = vec2(0.0);
  knot.is_lost = false;
  if (solve(p, pixel, knot)) return knot;
  knot.uv = nearest_start(p, pixel, knot.uv);
  knot.is_lost = !solve(p, pixel, knot);
  if (knot.is_lost) knot.slope = vec2(0.0);
  return knot;
}

// Most that the first three derivatives of a cubic can be over a segment.
vec3 change(float len, float value, float next, float slope, float next_slope) {
  precise float rise = (next - value) / len;
  precise float middle = 3.0 * rise - (slope + next_slope);
  precise float to_middle = middle - slope;
  precise float from_middle = next_slope - middle;
  precise float per_length = 2.0 / len;
  precise float third = per_length * abs(from_middle - to_middle) / len;
  return vec3(max(max(abs(slope), abs(next_slope)), abs(middle)),
              per_length * max(abs(to_middle), abs(from_middle)), third);
}

float second_term(int p, float a, float b, float to_a, float to_b) {
  precise float sum = (most(p, 2, 0) * (a * to_a) + most(p, 1, 1) * (a * to_b + b * to_a)) +
                      most(p, 0, 2) * (b * to_b);
  return sum;
}

// Most that the fourth derivative of the place on the surface along the row can be.
float fourth_derivative(int p, vec3 u, vec3 v) {
  precise float uu = u.x * u.x;
  precise float uv = u.x * v.x;
  precise float vv = v.x * v.x;
  precise float of_fourth =
      uv * ((4.0 * most(p, 3, 1) * uu + 6.0 * most(p, 2, 2) * uv) + 4.0 * most(p, 1, 3) * vv);
  precise float u_twice = (most(p, 3, 0) * uu + 2.0 * most(p, 2, 1) * uv) + most(p, 1, 2) * vv;
  precise float v_twice = (most(p, 2, 1) * uu + 2.0 * most(p, 1, 2) * uv) + most(p, 0, 3) * vv;
  precise float of_third = 6.0 * (u_twice * u.y + v_twice * v.y);
  precise float of_second = 3.0 * second_term(p, u.y, v.y, u.y, v.y) +
                            4.0 * second_term(p, u.x, v.x, u.z, v.z);
  return (of_fourth + of_third) + of_second;
}

// Whether cubics between two knots are near enough to the surface.
bool are_near(int p, float len, Knot a, Knot b) {
  if (a.is_lost || b.is_lost) return false;
  float safe = max(len, 1.0);
  float fourth = fourth_derivative(p, change(safe, a.uv.x, b.uv.x, a.slope.x, b.slope.x),
                                   change(safe, a.uv.y, b.uv.y, a.slope.y, b.slope.y));
  vec2 low = min(a.uv, b.uv), high = max(a.uv, b.uv);
  bool on_border = any(lessThanEqual(low, vec2(0.0))) || any(greaterThanEqual(high, vec2(1.0)));
  float allowed = on_border ? INTERPOLATION_ERROR - FLATNESS : INTERPOLATION_ERROR;
  precise float squared = safe * safe;
  precise float off = (1.0 / 384.0) * (squared * squared) * fourth;
  return off <= allowed;
}

void polish(int p, vec2 pixel, inout vec2 uv) {
  for (int n = 0; n < MOST_POLISH_STEPS; ++n) {
    vec2 step = approach(position(p, uv), pixel, uv);
    precise float left = (most(p, 2, 0) * (step.x * step.x) + most(p, 0, 2) * (step.y * step.y)) +
                         2.0 * most(p, 1, 1) * abs(step.x * step.y);
    if (!(left > 2.0 * FLATNESS)) return;
  }
}

float between(int basis, int i, float value, float next, float slope, float next_slope) {
  int at = basis + i;
  precise float sum =
      (value * bases[at] + next * bases[at + 2 * MOST_LENGTH]) +
      (slope * bases[at + 4 * MOST_LENGTH] + next_slope * bases[at + 6 * MOST_LENGTH]);
  return sum;
}

float polynomial(int p, int channel, bool bilinear, vec2 uv) {
  int c = 16 * channel;
  precise float row[4];
  for (int i = 0; i < (bilinear ? 2 : 4); ++i) {
    precise float inner = patches[p].color[c + 4 * i + 1];
    if (!bilinear) {
      precise float upper = patches[p].color[c + 4 * i + 2] + uv.y * patches[p].color[c + 4 * i + 3];
      inner = patches[p].color[c + 4 * i + 1] + uv.y * upper;
    }
    row[i] = patches[p].color[c + 4 * i] + uv.y * inner;
  }
  precise float value = row[0] + uv.x * row[1];
  if (!bilinear) {
    precise float upper = row[2] + uv.x * row[3];
    value = row[0] + uv.x * (row[1] + uv.x * upper);
  }
  return value;
}

// As fill.cpp's Levels.
uint color_at(int p, vec2 uv) {
  uint flags = patches[p].flags;
  bool bilinear = (flags & 1u) != 0u, opaque = (flags & 2u) != 0u, masked = (flags & 4u) != 0u;
  float alpha = 1.0;
  if (!opaque) {
    alpha = min(max(polynomial(p, 3, bilinear, uv), 0.0), 1.0);
    if (masked) alpha = float(to_level(alpha * 255.0)) / 255.0;
  }
  uint color = 0u;
  for (int n = 0; n < 3; ++n) {
    float channel = polynomial(p, n, bilinear, uv);
    if (!opaque) {
      channel = masked ? float(to_level(channel)) : min(max(channel, 0.0), 255.0);
      precise float over = alpha * channel + (1.0 - alpha) * 255.0;
      channel = over;
    }
    color |= to_level(channel) << (8 * n);
  }
  return color;
}

void main() {
  Segment segment;
  if (!find_segment(segment)) return;
  int p = segment.span.patch_index;
  uint number = patches[p].number;
  int first = atlas_index(segment.tile, ivec2(segment.from, segment.span.y));
  bool is_seen = false;
  for (int i = 0; i < segment.to - segment.from; ++i)
    is_seen = is_seen || tops[first + i] == number;
  if (!is_seen) return;

  bool is_found = segment.span.parameters >= 0, near = false;
  Knot a, b;
  float len = 0.0, knot_x = 0.0;
  float y = float(segment.span.y - patches[p].y) + 0.5;
  if (!is_found) {
    int last = segment.span.x1 - segment.span.x0 - 1;
    int here = segment.k * MOST_LENGTH, next = min(here + MOST_LENGTH, last);
    here = min(here, last);
    len = float(next - here);
    knot_x = float(segment.span.x0 + here - patches[p].x) + 0.5;
    a = find_knot(p, vec2(knot_x, y));
    b = find_knot(p, vec2(float(segment.span.x0 + next - patches[p].x) + 0.5, y));
    near = are_near(p, len, a, b);
  }
  int basis = ((near ? 0 : MOST_LENGTH + 1) + int(len)) * 8 * MOST_LENGTH;
  for (int x = segment.from; x < segment.to; ++x) {
    int at = first + x - segment.from;
    if (tops[at] != number) continue;
    vec2 uv;
    if (is_found) {
      uv = found_parameters(segment, x);
    } else {
      int i = x - segment.start;
      uv = vec2(between(basis, i, a.uv.x, b.uv.x, a.slope.x, b.slope.x),
                between(basis, i, a.uv.y, b.uv.y, a.slope.y, b.slope.y));
      vec2 inside = clamp01(uv);
      if (!near || any(notEqual(inside, uv))) {
        uv = inside;
        polish(p, vec2(knot_x + float(i), y), uv);
      }
    }
    colors[at] = color_at(p, uv);
  }
}
