#include "reference/layout.h"

#include "raster/hidden.h"

namespace gradmesh {

Frame laid_out(const Mesh& mesh, const Layout& layout, int resolution) {
  Frame frame = fit_frame(mesh, layout.view, resolution, layout.padding);
  if (layout.visible) frame.hidden = std::make_shared<HiddenPixels>(*layout.visible, frame);
  frame.weights = weights_in(frame, layout.weighted);
  return frame;
}

}  // namespace gradmesh
