#include "formats/pdf/page/graphics_state.h"

#include <array>
#include <utility>

namespace gradmesh {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 15> css_words{
    {{"/Multiply", "multiply"},
     {"/Screen", "screen"},
     {"/Overlay", "overlay"},
     {"/Darken", "darken"},
     {"/Lighten", "lighten"},
     {"/ColorDodge", "color-dodge"},
     {"/ColorBurn", "color-burn"},
     {"/HardLight", "hard-light"},
     {"/SoftLight", "soft-light"},
     {"/Difference", "difference"},
     {"/Exclusion", "exclusion"},
     {"/Hue", "hue"},
     {"/Saturation", "saturation"},
     {"/Color", "color"},
     {"/Luminosity", "luminosity"}}};

}  // namespace

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

std::string blend_mode_of(QPDFObjectHandle modes) {
  if (modes.isArray()) {
    for (QPDFObjectHandle mode : modes.getArrayAsVector())
      if (mode.isName())
        if (const std::string word = blend_mode_of(mode); word != "normal") return word;
    return "normal";
  }
  if (modes.isName())
    for (const auto& [name, word] : css_words)
      if (modes.getName() == name) return word;
  return "normal";
}

}  // namespace gradmesh
