#include "formats/pdf/page/graphics_state.h"

#include <utility>

namespace gradmesh {

Mask through_both(const Mask& one, const Mask& other) {
  if (one && other) return std::make_shared<const std::vector<PaintedShading>>();
  return one ? one : other;
}

void begin_group(GraphicsState& state, PageGroup group) {
  group.around = std::move(state.group);
  group.opacity *= std::exchange(state.mask_opacity, 1);
  group.blend_mode = std::exchange(state.blend_mode, "normal");
  state.group = std::make_shared<const PageGroup>(std::move(group));
  state.opacity = state.stroke_opacity = 1;
  // What is inside may have a mask of its own, which is in place of none of these.
  state.clips.insert(state.clips.begin(), state.mask_clips.begin(), state.mask_clips.end());
  state.mask_clips.clear();
  state.group_mask = through_both(state.group_mask, std::exchange(state.mask, nullptr));
}

}  // namespace gradmesh
