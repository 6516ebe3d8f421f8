#pragma once

#include <vector>

#include "formats/pdf/page/patch_colors.h"
#include "formats/pdf/page/read_shading.h"

namespace gradmesh {

/// What a page shows of a shading.
struct PaintedPatches {
  /// Its own patches, in page coordinates, or in those of the pen that it strokes with.
  PageShading shading;
  /// The opacities of their corners, one for each of them.
  std::vector<CornerOpacities> opacities;
  /// The patches that show them as a mesh of SVG does, divided where their colours need it.
  std::vector<PagePatch> patches;
  /// What it is seen through beside its own clip paths: those of the mask that it has opacities of.
  Clips mask_clips = {};
  /// Whether it is seen through a mask that has no opacities for its corners: then it is as if
  /// there were none.
  bool mask_left_out = false;
};

/// Reads what a page shows of a shading of type 4 to 7. Throws InputError, whose message is a
/// clause, where nothing of it can be read.
PaintedPatches painted_patches(const PaintedShading& painted, KeptShadings& kept);

}  // namespace gradmesh
