#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "formats/pdf/shading/packing.h"
#include "formats/pdf/shading/patch_around.h"

namespace gradmesh {

/// A patch as a shading has it, in the shading's own coordinates.
using ShadingPatch = PatchAround<Components>;

/// What was read of a shading.
struct ShadingPatches {
  std::vector<ShadingPatch> patches;
  /// How many there are, those included that were not kept.
  std::size_t count = 0;
  /// Whether the data end within a patch, or one continues a patch that is not there: what lies
  /// before that was read.
  bool is_damaged = false;
};

enum class PatchKind { coons, tensor };

/// Reads the patches of a shading of type 6 (`coons`) or 7 (`tensor`), and keeps the first `most`,
/// at least one, of them. The packing has passed check().
ShadingPatches read_patches(std::string_view data, const Packing& packing, PatchKind kind,
                            std::size_t most);

}  // namespace gradmesh
