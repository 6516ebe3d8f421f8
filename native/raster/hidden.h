#pragma once

#include <memory>
#include <vector>

#include "base/affine.h"
#include "geom/outline.h"
#include "raster/painting.h"

namespace gradmesh {

/// Pixels of a frame that are never painted, as nothing of them is seen.
class HiddenPixels {
 public:
  /// Pixels [begin, end) of a row.
  struct Run {
    int begin, end;

    bool operator==(const Run&) const = default;
  };

  /// Finds the pixels outside of `area`. A pixel is hidden if the area meets none of five lines
  /// through it, at its upper and lower edge and at the quarters between: so a pixel of which more
  /// than a sliver is seen is never hidden.
  HiddenPixels(const VisibleArea& area, const Frame& frame);

  /// Returns true if the pixel is hidden. Pixels beyond the frame are not.
  bool contains(int x, int y) const;
  const std::vector<Run>& row(int y) const { return rows_[std::size_t(y)]; }
  /// Makes the hidden pixels of the window as grey as the ground again.
  void hide(Window window, std::uint8_t ground, Painting& painting) const;

 private:
  std::vector<std::vector<Run>> rows_;
};

}  // namespace gradmesh
