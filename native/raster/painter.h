#pragma once

#include <vector>

#include "raster/fill.h"
#include "raster/painting.h"

namespace gradmesh {

/// Returns the patch of a face as it is painted: in the colour model `bilinear` as it will be
/// written.
Patch painted_patch(const Mesh& mesh, const Frame& frame, Face face);

/// Paints meshes, and paints again what an edit changed, pixel for pixel as Rasterizer does. Not
/// thread-safe, as it keeps its memory from call to call.
class Painter {
 public:
  /// Paints the whole of the painting's window, which lies inside the frame.
  void paint(const Mesh& mesh, const Frame& frame, Painting& painting);

  /// Paints one face and nothing else over `within`, which lies inside the painting's window.
  void paint_alone(const Mesh& mesh, const Frame& frame, Face face, Window within,
                   Painting& painting);

  /// Brings the painting of a mesh up to date for the mesh as it is now. `touched`, in rising
  /// order, are the faces whose patch or outline changed; some may be gone and some new. `within`
  /// holds their pixels before and after, as far as they lie in the painting's window. A smooth
  /// mesh is painted anew in the painting's whole window.
  void repaint(const Mesh& mesh, const Frame& frame, const std::vector<Face>& touched,
               Window within, Painting& painting);

 private:
  void paint_face(const Mesh& mesh, const Frame& frame, Face face, Window window,
                  Painting& painting);
  /// Takes the pixels of the touched faces away. Returns a window that holds those of the pixels
  /// where other faces may lie below.
  Window clear(const std::vector<Face>& touched, Window within, std::uint8_t ground,
               Painting& painting);
  bool is_touched(Face face) const {
    return std::size_t(face.value) < is_touched_.size() && is_touched_[face.value];
  }

  Tessellator tessellator_;
  FaceShape shape_;
  Parameters parameters_;
  std::vector<char> is_touched_;
};

}  // namespace gradmesh
