#pragma once

#include <memory>
#include <vector>

#include "base/affine.h"
#include "geom/outline.h"
#include "raster/painting.h"

namespace gradmesh {

/// Pixels of a frame that are never painted: those of which nothing is seen.
class HiddenPixels {
 public:
  /// Pixels [begin, end) of a row.
  struct Run {
    int begin, end;

    bool operator==(const Run&) const = default;
  };

  /// A pixel is hidden where the area meets none of five lines through it, at its upper and lower
  /// edge and at quarters between: so never one of which more than a sliver is seen.
  HiddenPixels(const VisibleArea& area, const Frame& frame);

  /// Whether the pixel is hidden; those beyond the frame are not.
  bool contains(int x, int y) const;
  const std::vector<Run>& row(int y) const { return rows_[std::size_t(y)]; }
  /// Makes them white again, in the window.
  void hide(Window window, Painting& painting) const;

 private:
  std::vector<std::vector<Run>> rows_;
};

}  // namespace gradmesh
