#pragma once

#include "raster/painting.h"
#include "session/analysis.h"
#include "session/canvas.h"

namespace gradmesh {

/// Draws what is known of a mesh over its picture, which `fade` has made pale and gray.
class Overlay {
 public:
  /// `top` has the face on top of each pixel of the canvas.
  Overlay(Canvas& canvas, const Mesh& mesh, const Affine& to_pixels,
          const Raster<std::uint32_t, 1>& top)
      : canvas_(canvas), mesh_(mesh), to_pixels_(to_pixels), top_(top) {}

  /// Makes a picture gray and pale, so that colours over it can be told apart.
  static void fade(Image& picture);

  /// Draws curves in the colours of what they cost, the costly ones last.
  void draw_prices(const std::vector<CurvePrice>& prices);
  /// Draws a patch, and a region that holds it if that is not null.
  void draw_region(Face patch, const RegionPrice* region);
  /// Draws the parts of a motorcycle graph and the edges between them.
  void draw_parts(const MotorcycleGraph& graph);

 private:
  void draw_curves(const std::vector<Halfedge>& curves, const Ink& ink);
  void draw_sides(const std::vector<Halfedge>& sides, const Ink& ink);
  void tint(const std::vector<Face>& faces, const Ink& ink);

  Canvas& canvas_;
  const Mesh& mesh_;
  const Affine to_pixels_;
  const Raster<std::uint32_t, 1>& top_;
};

}  // namespace gradmesh
