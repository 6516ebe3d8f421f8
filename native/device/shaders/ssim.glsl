// 1 - SSIM of a block's pixels: the formulas of ssim.cpp, which says why.

// The reference's pixels.
layout(std430, binding = 6) readonly buffer ReferenceColors { uint reference_colors[]; };

shared float planes[3][around * around];
shared float columns[3][side * around];

// Levels are taken less this, as small numbers and their squares round less.
const float level_centre = 128.0;

#if PASS == REFERENCE

// Mean and variance down a column and then along the row, each about the sample at the centre,
// where nothing large cancels.
vec2 find_moments(int c) {
  for (int i = int(gl_LocalInvocationIndex); i < side * around; i += threads) {
    int at = i + REACH * around;
    float near = planes[c][at];
    precise float shift = 0.0, squares = 0.0;
    for (int k = REACH; k > 0; --k) {
      float above = planes[c][at - k * around] - near, below = planes[c][at + k * around] - near;
      shift += GAUSSIAN_TAPS[k] * (above + below);
      squares += GAUSSIAN_TAPS[k] * (above * above + below * below);
    }
    columns[0][i] = near + shift;
    columns[1][i] = squares - shift * shift;
  }
  barrier();
  int at = int(gl_LocalInvocationID.y) * around + int(gl_LocalInvocationID.x) + REACH;
  float near = columns[0][at];
  precise float shift = 0.0, squares = 0.0;
  for (int k = REACH; k > 0; --k) {
    float before = columns[0][at - k] - near, after = columns[0][at + k] - near;
    shift += GAUSSIAN_TAPS[k] * (before + after);
    squares += GAUSSIAN_TAPS[k] * ((before * before + after * after) +
                                   (columns[1][at - k] + columns[1][at + k]));
  }
  squares += GAUSSIAN_TAPS[0] * columns[1][at];
  barrier();
  return vec2(near + shift, squares - shift * shift);
}

#else

float along(int plane) {
  int at = int(gl_LocalInvocationID.y) * around + int(gl_LocalInvocationID.x) + REACH;
  precise float sum = 0.0;
  for (int k = REACH; k > 0; --k)
    sum += GAUSSIAN_TAPS[k] * (columns[plane][at - k] + columns[plane][at + k]);
  sum += GAUSSIAN_TAPS[0] * columns[plane][at];
  return sum;
}

// The distance in one channel. In the planes: the difference, its square, and its product with the
// reference.
float channel_distance(Tile tile, ivec2 corner, int c, int at_reference) {
  for (int i = int(gl_LocalInvocationIndex); i < around * around; i += threads) {
    ivec2 p = pixel_around(corner, i);
    float wanted = levels(reference_colors[frame_index(p)])[c];
    float difference = levels(color_of(tile, p))[c] - wanted;
    planes[0][i] = difference;
    planes[1][i] = difference * difference;
    planes[2][i] = difference * (wanted - level_centre);
  }
  barrier();
  for (int i = int(gl_LocalInvocationIndex); i < side * around; i += threads) {
    int at = i + REACH * around;
    for (int plane = 0; plane < 3; ++plane) {
      precise float sum = 0.0;
      for (int k = REACH; k > 0; --k)
        sum += GAUSSIAN_TAPS[k] * (planes[plane][at - k * around] + planes[plane][at + k * around]);
      columns[plane][i] = sum + GAUSSIAN_TAPS[0] * planes[plane][at];
    }
  }
  barrier();
  const float c1 = 6.5025, c2 = 58.5225;  // (0.01 * 255)^2, (0.03 * 255)^2
  float my = reference[at_reference + c * plane_size];
  float vy = reference[at_reference + (3 + c) * plane_size];
  precise float md = along(0);
  precise float m = my + level_centre;
  precise float mx = m + md;
  precise float md2 = md * md;
  precise float p_below = (m * m + mx * mx) + c1;
  precise float vd = max(0.0, along(1) - md2);
  precise float covariance = along(2) - my * md;
  precise float both_variances = (vy + covariance) + (vy + covariance);
  precise float q_below = (both_variances + vd) + c2;
  precise float above = md2 * q_below + vd * (p_below - md2);
  precise float distance = above / (p_below * q_below);
  barrier();
  return distance;
}

#endif

void measure(int block, Tile tile, ivec2 corner, ivec2 p) {
#if PASS == REFERENCE
  for (int i = int(gl_LocalInvocationIndex); i < around * around; i += threads) {
    vec3 level = levels(color_of(tile, pixel_around(corner, i)));
    for (int c = 0; c < 3; ++c) planes[c][i] = level[c] - level_centre;
  }
  barrier();
  for (int c = 0; c < 3; ++c) {
    vec2 moments = find_moments(c);
    if (!is_measured(tile, p)) continue;
    reference[frame_index(p) + c * plane_size] = moments.x;
    reference[frame_index(p) + (3 + c) * plane_size] = moments.y;
  }
#else
  precise float sum = 0.0;
  int at = frame_index(in_frame(p));
  for (int c = 0; c < 3; ++c) sum += channel_distance(tile, corner, c, at);
  write_distance(block, tile, p, sum * (1.0 / 3.0));
#endif
}
