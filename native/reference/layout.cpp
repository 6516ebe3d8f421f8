#include "reference/layout.h"

#include "raster/hidden.h"

namespace gradmesh {

Frame laid_out(const Original& original, const Layout& layout, int resolution) {
  Frame frame = original.frame(layout.view, resolution, layout.padding);
  if (layout.visible) frame.hidden = std::make_shared<HiddenPixels>(*layout.visible, frame);
  frame.weights = weights_in(frame, layout.weighted);
  return frame;
}

}  // namespace gradmesh
