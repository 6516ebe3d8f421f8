#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "formats/pdf/page/painted_patches.h"

namespace gradmesh {

/// A shading and what a page shows of it.
struct ShadingOnPage {
  /// Its number among those that the page paints, from 0.
  std::size_t number = 0;
  PaintedShading painted;
  PaintedPatches shown;
};

/// Shadings that a page paints one after another. Programs that draw the surface of a function
/// (Asymptote, for one) paint hundreds of them, of two patches each, as its tiles.
class PageTiles {
 public:
  /// Takes a shading in and returns true, if it may belong to the same surface as those so far: it
  /// is as small as a tile, painted alike, and seen through the same clip paths but for one around
  /// the tile alone. The first one may be any.
  bool take(ShadingOnPage& next);

  /// Some of them that follow one another: their first, and the one behind their last.
  struct Span {
    std::size_t begin, end;
  };

  const std::vector<ShadingOnPage>& shadings() const { return shadings_; }
  /// Returns all of them in order, cut where those before share no corner with those behind.
  std::vector<Span> surfaces() const;
  /// Returns the patches of some as those of one shading; nothing where these are too few for
  /// tiles. Whether they join is to be seen.
  std::optional<ShadingOnPage> surface(Span span) const;

 private:
  std::vector<ShadingOnPage> shadings_;
  /// The clip paths of the first shading, without one that hides nothing of it.
  Clips around_;
  /// Whether all have the same clip paths, and whether they have without such ones.
  bool has_same_clips_ = true, has_same_around_ = true;
};

}  // namespace gradmesh
