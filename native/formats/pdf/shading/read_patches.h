#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "formats/pdf/shading/packing.h"

namespace gradmesh {

/// A patch as a shading has it, in the shading's own coordinates.
struct ShadingPatch {
  /// Bezier control points p(i, j), i along u and j along v.
  std::array<std::array<glm::dvec2, 4>, 4> points{};
  /// At (u, v) = (0, 0), (0, 1), (1, 1), (1, 0).
  std::array<Components, 4> colors;

  bool operator==(const ShadingPatch&) const = default;
};

/// What was read of a shading.
struct ShadingPatches {
  std::vector<ShadingPatch> patches;
  /// Whether the data end within a patch, or one continues a patch that is not there: what lies
  /// before that was read.
  bool is_damaged = false;
};

enum class PatchKind { coons, tensor };

/// Reads the patches of a shading of type 6 (`coons`) or 7 (`tensor`), but at most `most`. The
/// packing has passed check().
ShadingPatches read_patches(std::string_view data, const Packing& packing, PatchKind kind,
                            std::size_t most);

}  // namespace gradmesh
