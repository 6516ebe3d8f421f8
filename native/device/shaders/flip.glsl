// FLIP of a block's pixels: the arithmetic of appearance.cpp and flip.cpp, which say why.

// Linear light of the 256 levels.
layout(std430, binding = 6) readonly buffer LinearLight { float linear_light[]; };

// CIE XYZ over white: y, x - y, y - z.
shared float opponent[3][around * around];

const int y_column = 0, cx_column = 1, cz_wide_column = 2, cz_narrow_column = 3, smooth_column = 4,
          slope_column = 5, curvature_column = 6;
shared float columns[7][side * around];

float product(float m[9], int row, vec3 v) {
  precise float sum = (m[3 * row] * v.x + m[3 * row + 1] * v.y) + m[3 * row + 2] * v.z;
  return sum;
}

vec3 product(float m[9], vec3 v) {
  return vec3(product(m, 0, v), product(m, 1, v), product(m, 2, v));
}

void read_around(Tile tile, ivec2 corner) {
  for (int i = int(gl_LocalInvocationIndex); i < around * around; i += threads) {
    vec3 level = levels(color_of(tile, pixel_around(corner, i)));
    vec3 light = vec3(linear_light[int(level.r)], linear_light[int(level.g)],
                      linear_light[int(level.b)]);
    vec3 value = product(RGB_TO_OPPONENT, light);
    opponent[0][i] = value.x;
    opponent[1][i] = value.y;
    opponent[2][i] = value.z;
  }
}

// The filters down the columns, from the farthest pair of pixels to the nearest.
void filter_down() {
  for (int i = int(gl_LocalInvocationIndex); i < side * around; i += threads) {
    int at = i + REACH * around;
    float centre = opponent[0][at];
    precise float blurred = 0.0, even = 0.0, slope = 0.0, curvature = 0.0;
    for (int k = FEATURE_REACH; k > 0; --k) {
      float above = opponent[0][at - k * around], below = opponent[0][at + k * around];
      float both = above + below;
      if (k <= SHORT_REACH) blurred += LUMINANCE_TAPS[k] * both;
      even += SMOOTH_TAPS[k] * both;
      slope += SLOPE_TAPS[k] * (below - above);
      curvature += CURVATURE_TAPS[k] * (both - (centre + centre));
    }
    columns[y_column][i] = blurred + LUMINANCE_TAPS[0] * centre;
    columns[smooth_column][i] = even + SMOOTH_TAPS[0] * centre;
    columns[slope_column][i] = slope;
    columns[curvature_column][i] = curvature;

    precise float red_green = 0.0;
    for (int k = SHORT_REACH; k > 0; --k)
      red_green +=
          RED_GREEN_TAPS[k] * (opponent[1][at - k * around] + opponent[1][at + k * around]);
    columns[cx_column][i] = red_green + RED_GREEN_TAPS[0] * opponent[1][at];

    precise float wide = 0.0, narrow = 0.0;
    for (int k = REACH; k > 0; --k) {
      float both = opponent[2][at - k * around] + opponent[2][at + k * around];
      wide += BLUE_YELLOW_WIDE_TAPS[k] * both;
      narrow += BLUE_YELLOW_NARROW_TAPS[k] * both;
    }
    columns[cz_wide_column][i] = wide + BLUE_YELLOW_WIDE_TAPS[0] * opponent[2][at];
    columns[cz_narrow_column][i] = narrow + BLUE_YELLOW_NARROW_TAPS[0] * opponent[2][at];
  }
}

float pair(int column, int at, int k) { return columns[column][at - k] + columns[column][at + k]; }

float cube_root(float t) {
  int third = int(float(floatBitsToInt(t)) * (1.0 / 3.0));
  float rough = intBitsToFloat(0x54a23000 - third);
  precise float e = 1.0 - (t * rough) * (rough * rough);
  precise float r = rough + rough * (e * ((2.0 / 9.0) * e + 1.0 / 3.0));
  precise float root = (t * r) * r;
  precise float rest = 1.0 - root * r;
  precise float result = root + root * (rest * ((5.0 / 9.0) * rest + 2.0 / 3.0));
  return result;
}

float lab_curve(float t) {
  const float delta = 6.0 / 29.0, knee = delta * delta * delta;
  precise float line = (1.0 / (3.0 * delta * delta)) * t + 4.0 / 29.0;
  return t > knee ? cube_root(t) : line;
}

struct Appearance {
  float lightness, a, b, edge, point;
};

vec3 perceived(float y, float cx, float cz) {
  vec3 rgb = product(OPPONENT_TO_RGB, vec3(y, cx, cz));
  vec3 xyz = product(RGB_TO_WHITE_XYZ, min(max(rgb, vec3(0.0)), vec3(1.0)));
  float fx = lab_curve(xyz.x), fy = lab_curve(xyz.y), fz = lab_curve(xyz.z);
  precise float lightness = 116.0 * fy - 16.0;
  precise float hunt = 0.01 * lightness;
  precise float a = (hunt * 500.0) * (fx - fy);
  precise float b = (hunt * 200.0) * (fy - fz);
  return vec3(lightness, a, b);
}

float magnitude(float x, float y) {
  precise float squares = x * x + y * y;
  return sqrt(squares);
}

// The filters along the row, and what follows them.
Appearance appearance() {
  int at = int(gl_LocalInvocationID.y) * around + int(gl_LocalInvocationID.x) + REACH;
  precise float y = 0.0, cx = 0.0, wide = 0.0, narrow = 0.0;
  for (int k = SHORT_REACH; k > 0; --k) {
    y += LUMINANCE_TAPS[k] * pair(y_column, at, k);
    cx += RED_GREEN_TAPS[k] * pair(cx_column, at, k);
  }
  y += LUMINANCE_TAPS[0] * columns[y_column][at];
  cx += RED_GREEN_TAPS[0] * columns[cx_column][at];
  for (int k = REACH; k > 0; --k) {
    wide += BLUE_YELLOW_WIDE_TAPS[k] * pair(cz_wide_column, at, k);
    narrow += BLUE_YELLOW_NARROW_TAPS[k] * pair(cz_narrow_column, at, k);
  }
  wide += BLUE_YELLOW_WIDE_TAPS[0] * columns[cz_wide_column][at];
  narrow += BLUE_YELLOW_NARROW_TAPS[0] * columns[cz_narrow_column][at];

  float twice = columns[smooth_column][at] + columns[smooth_column][at];
  precise float slope_x = 0.0, slope_y = 0.0, curvature_x = 0.0, curvature_y = 0.0;
  for (int k = FEATURE_REACH; k > 0; --k) {
    slope_x += SLOPE_TAPS[k] * (columns[smooth_column][at + k] - columns[smooth_column][at - k]);
    curvature_x += CURVATURE_TAPS[k] * (pair(smooth_column, at, k) - twice);
    slope_y += SMOOTH_TAPS[k] * pair(slope_column, at, k);
    curvature_y += SMOOTH_TAPS[k] * pair(curvature_column, at, k);
  }
  slope_y += SMOOTH_TAPS[0] * columns[slope_column][at];
  curvature_y += SMOOTH_TAPS[0] * columns[curvature_column][at];

  vec3 lab = perceived(y, cx, wide + narrow);
  return Appearance(lab.x, lab.y, lab.z, magnitude(slope_x, slope_y),
                    magnitude(curvature_x, curvature_y));
}

float log2_positive(float x) {
  int exponent = (floatBitsToInt(x) - 0x3f3504f3) >> 23;
  float m = intBitsToFloat(floatBitsToInt(x) - (exponent << 23));
  precise float s = (m - 1.0) / (m + 1.0);
  precise float s2 = s * s;
  precise float series = (1.0 / 9.0) * s2 + 1.0 / 7.0;
  series = s2 * series + 1.0 / 5.0;
  series = s2 * series + 1.0 / 3.0;
  series = s2 * series + 1.0;
  precise float result = float(exponent) + (2.88539008 * s) * series;
  return result;
}

float exp2_bounded(float y) {
  int biased = int(y + 127.5);
  precise float t = (y - float(biased - 127)) * 0.693147181;
  precise float series = (1.0 / 5040.0) * t + 1.0 / 720.0;
  series = t * series + 1.0 / 120.0;
  series = t * series + 1.0 / 24.0;
  series = t * series + 1.0 / 6.0;
  series = t * series + 0.5;
  series = t * series + 1.0;
  series = t * series + 1.0;
  return series * intBitsToFloat(biased << 23);
}

float log2_color(float hyab) {
  const float greatest = 41.276096, knee = 0.4 * greatest, at_knee = 0.95;
  precise float log2_distance = 0.7 * log2_positive(hyab);
  precise float log2_near = log2_distance - 4.11930714;  // log2(at_knee / knee)
  if (log2_near < -0.0740005995) return log2_near;       // log2(at_knee)
  precise float far =
      ((1.0 - at_knee) / (greatest - knee)) * (exp2_bounded(log2_distance) - knee) + at_knee;
  return log2_positive(far);
}

float distance_between(Appearance s, Appearance t) {
  precise float hyab = abs(s.lightness - t.lightness) + magnitude(s.a - t.a, s.b - t.b);
  if (!(hyab > 0.0)) return 0.0;
  float greater = max(abs(s.edge - t.edge), abs(s.point - t.point));
  precise float exponent = 1.0 - sqrt(greater * 0.707106781);
  precise float power = exponent * log2_color(hyab);
  return exp2_bounded(power);
}

void measure(int block, Tile tile, ivec2 corner, ivec2 p) {
  read_around(tile, corner);
  barrier();
  filter_down();
  barrier();
  Appearance seen = appearance();
  int at = frame_index(p);
#if PASS == REFERENCE
  if (!is_measured(tile, p)) return;
  reference[at] = seen.lightness;
  reference[at + plane_size] = seen.a;
  reference[at + 2 * plane_size] = seen.b;
  reference[at + 3 * plane_size] = seen.edge;
  reference[at + 4 * plane_size] = seen.point;
#else
  at = frame_index(in_frame(p));
  Appearance wanted =
      Appearance(reference[at], reference[at + plane_size], reference[at + 2 * plane_size],
                 reference[at + 3 * plane_size], reference[at + 4 * plane_size]);
  write_distance(block, tile, p, distance_between(wanted, seen));
#endif
}
