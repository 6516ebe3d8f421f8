#pragma once

#include <vector>

#include "base/image.h"

namespace gradmesh {

/// Appends to `tiles` windows that together hold every pixel of `window` within `reach` of a pixel
/// in which the two images differ, and few others. The windows do not overlap, come from top to
/// bottom, are at most `largest_height` rows high, and narrow enough for the arrays that a metric
/// computes for one of them to stay in the cache. Differences are looked for in `searched` only,
/// which both images cover.
void append_tiles_near_differences(const Image& a, const Image& b, Window searched, Window window,
                                   int reach, int largest_height, std::vector<Window>& tiles);

}  // namespace gradmesh
