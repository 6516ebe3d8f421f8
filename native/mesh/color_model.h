#pragma once

#include "mesh/parts.h"

namespace gradmesh {

/// Conversions between the colour models (README). They change colours only.

/// Returns the mesh in the model `bilinear`: the colours of the corners, limited to [0, 1], and
/// nothing between them, which is what SVG can hold. The difference to the original shrinks with
/// the square of the size of patches; see subdivided().
MeshParts as_bilinear(MeshParts parts);

/// Returns the mesh in the model `bicubic`: each patch gets the colour tangents and twists of the
/// bilinear mixture of its corners, so that it looks the same. That is not possible where the two
/// sides of a curve have different colours, since they share their tangents, nor where a bar ends
/// in a colour of its own, since the bar takes its tangents from the parent.
MeshParts as_bicubic(MeshParts parts);

}  // namespace gradmesh
