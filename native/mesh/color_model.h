#pragma once

#include "mesh/parts.h"

namespace gradmesh {

/// Conversions between the colour models (README). They change colours only.

/// Keeps the colours of the corners, limited to [0, 1], and nothing between them: what SVG can
/// hold. How far that is from the original shrinks with the square of the size of patches; see
/// subdivided().
MeshParts as_bilinear(MeshParts parts);

/// Gives each patch the colour tangents and twists of the bilinear mixture of its corners, so that
/// it looks the same. That is not possible where the two sides of a curve have different colours,
/// since they share their tangents, nor where a bar ends in a colour of its own, since it takes its
/// tangents from the parent.
MeshParts as_bicubic(MeshParts parts);

}  // namespace gradmesh
