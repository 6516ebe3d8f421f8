#pragma once

#include "app/editing/edits.h"

namespace gradmesh {

/// Makes the selected meshes ordinary ones: the line that ends at a T-junction goes on across the
/// mesh, which is exact but for the rounding of colours at new points to 8 bits. In SVG groups of
/// blocks become objects with one mesh gradient again; ids that name other meshes are ignored. The
/// reported error is against the mesh as it was. Throws InputError, and leaves the document
/// unchanged, if there is nothing to be done, if a mesh would have more than 100,000 patches, or,
/// in SVG, if one is no rectangle (holes, branches) or has several colours at one point.
std::vector<EditReport> to_one_mesh(Document& document, const std::vector<std::string>& ids,
                                    const MeasureOptions& measure = {});

}  // namespace gradmesh
