#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "geom/outline.h"
#include "mesh/mesh.h"
#include "raster/frame.h"
#include "raster/painting.h"
#include "reference/outlines.h"

namespace gradmesh {

/// What meshes are measured against, at whatever resolution: something that has a picture and lies
/// in the units of the meshes. Originals never change, and their members may be called
/// concurrently.
class Original {
 public:
  virtual ~Original() = default;

  /// Returns the frame in which the original lies as fit_frame says. Throws InputError as fit_frame
  /// does.
  virtual Frame frame(const Affine& view, int resolution, const FramePadding& padding) const = 0;
  /// Paints the whole of the painting's window, which lies inside the frame, without a mask of
  /// opacities.
  virtual void paint(const Frame& frame, Painting& painting) const = 0;
  /// Returns true if the ground of a frame shows through somewhere inside the original.
  virtual bool is_translucent() const = 0;
  /// Returns the outlines that are known as curves.
  virtual OutlinePoints outlines(const Frame& frame) const = 0;
  /// Returns a hash of all that the original's picture depends on.
  virtual std::uint64_t hash() const = 0;
  /// Returns the mesh whose picture the original is; null if it is no mesh.
  virtual std::shared_ptr<const Mesh> mesh() const { return nullptr; }
  /// Returns true if the original is a picture, from which a mesh differs at first.
  virtual bool is_picture() const { return false; }

  /// Paints the whole frame.
  Painting painted(const Frame& frame) const;
};

/// Returns the original that is the picture of a mesh; null if the mesh is null.
std::shared_ptr<const Original> original_of(std::shared_ptr<const Mesh> mesh);

/// Returns the original that is a picture, such as a photograph from which a mesh was traced.
/// `to_units` maps its pixels, of which (x, y) has its centre at (x + 0.5, y + 0.5), to the units
/// of the meshes. Throws std::invalid_argument if the picture has no pixels or the map no inverse.
std::shared_ptr<const Original> original_of(RgbaImage picture, const Affine& to_units);

/// Returns the original that is another one, but has the picture of a mesh in some areas, which are
/// in the units of the meshes.
std::shared_ptr<const Original> with_areas(std::shared_ptr<const Original> base,
                                           std::shared_ptr<const Mesh> mesh,
                                           const std::vector<FilledOutline>& areas);

}  // namespace gradmesh
