#pragma once

#include <cstdint>

#include "base/image.h"

namespace gradmesh {

/// Side, in pixels, of the windows in which details are looked at. Where the picture is shown at
/// twice the resolution at which errors are measured, these are windows of 8 x 8 pixels: of the
/// sizes that were looked at, the one whose largest mean best tells what people see from what they
/// do not.
inline constexpr int detail_side = 4;

/// Returns the window of a pixel, which begins two pixels above and to the left of it.
constexpr Window detail_window(int x, int y) {
  constexpr int before = detail_side / 2;
  return {x - before, y - before, x - before + detail_side, y - before + detail_side};
}

/// Brings a map of the means of `errors` in the windows (detail_window) of each pixel up to
/// date, where `errors` has changed at most inside `changed`. Pixels beyond the frame, and those
/// for which `counts` is 0, have no error. `counts` is of the size of the frame. Of that, `errors`
/// has at least the pixels within 4 of `changed`, and `means` those within 2.
void update_detail_errors(const Plane& errors, const Raster<std::uint8_t, 1>& counts,
                          Window changed, Plane& means);

}  // namespace gradmesh
