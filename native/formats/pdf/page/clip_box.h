#pragma once

#include "formats/pdf/page/graphics_state.h"

namespace gradmesh {

/// Adds the box of a form or a shading, if it has one, to what it is seen through (ISO 32000-1,
/// 8.10.2 and 8.7.4.3). `to_page` maps its coordinates to those of the page.
void clip_to_box(Clips& clips, QPDFObjectHandle object, const Affine& to_page);

}  // namespace gradmesh
