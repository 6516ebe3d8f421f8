#pragma once

#include <optional>
#include <vector>

#include "formats/pdf/shading/read_patches.h"

namespace gradmesh {

/// Returns the patch of which two are the halves, if they are, each of its control points within
/// `tolerance`, listed so that they met where its side 0 ends in the first half; nothing otherwise.
/// The corners where they meet must have about the same colours.
std::optional<ShadingPatch> joined(const ShadingPatch& a, const ShadingPatch& b, double tolerance);

/// Takes back what Illustrator and InDesign do to an artist's patches, which they halve again and
/// again, until bilinear colours suffice, and write one half after all of the other: joins halves
/// that follow one another, of any listing. Patches are in points. What an artist has drawn as two
/// halves of one patch is joined too, and errors that add up keep some from being joined.
std::vector<ShadingPatch> without_halving(const std::vector<ShadingPatch>& patches);

}  // namespace gradmesh
