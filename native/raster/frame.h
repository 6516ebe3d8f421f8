#pragma once

#include <cstdint>
#include <memory>

#include "base/affine.h"
#include "base/image.h"
#include "geom/box.h"
#include "mesh/mesh.h"

namespace gradmesh {

class HiddenPixels;

/// How a mesh is laid out on an image; pixel (x, y) has its centre at (x + 0.5, y + 0.5).
struct Frame {
  int width = 0, height = 0;
  /// The map from mesh units to pixels.
  Affine to_pixels = {};
  /// True if opacities are painted as the writer holds them, in a mask of 8 bits a pixel. The
  /// original is painted without a mask.
  bool masked_opacity = false;
  /// The grey on which the mesh lies, 0..255: what shows through where it is translucent.
  std::uint8_t ground = 255;
  /// Pixels that stay of the ground whatever covers them (hidden.h); null: none.
  std::shared_ptr<const HiddenPixels> hidden = nullptr;
  /// How often the error of each pixel counts (Metric::Weights); null: once. Nothing is painted
  /// otherwise because of it.
  std::shared_ptr<const Plane> weights = nullptr;

  Window window() const { return {0, 0, width, height}; }
};

/// What is added on every side of a mesh's bounding box: a share of the box's longer side, and a
/// length in the units of the box.
struct FramePadding {
  double share = 0.015;
  double length = 0;
};

/// Returns the frame of the paper's section 5: the longer side of the mesh's bounding box, padded,
/// gets `resolution` pixels; the other side is cut to a whole number. `view` maps mesh units to
/// what the person sees, up to scale; the box is that of the mesh so mapped. Throws InputError if
/// the mesh has no size, or one beyond reason, or if the frame is beyond the limits on resolution
/// or memory.
Frame fit_frame(const Mesh& mesh, const Affine& view, int resolution, FramePadding padding = {});

/// Returns the frame of something else with that bounding box as `view` maps it, in the same way.
Frame fit_frame(const Box& seen, const Affine& view, int resolution, FramePadding padding = {});

/// Returns how far an interior control point may be from the Coons patch's, in mesh units, for a
/// writer to leave `tensor` out: a hundredth of a pixel of the frame. Painting a mesh of the colour
/// model `bilinear` leaves it out likewise.
double coons_tolerance(const Frame& frame);

/// Returns about how many bytes it takes to measure errors in the frame on `threads` threads, as
/// found by running gqe and best at 350 to 2800 pixels.
std::uint64_t measuring_bytes(const Frame& frame, std::size_t threads);

/// Returns the pixels that a patch can cover, not clipped to the frame.
Window pixel_bounds(const Patch& patch, const Frame& frame);

}  // namespace gradmesh
