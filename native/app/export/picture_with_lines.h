#pragma once

#include "app/document/document.h"

namespace gradmesh {

/// Paints a mesh in its own frame, as Document::render does in software, with its curves over it.
Image picture_with_lines(const Document& document, const MeshEntry& entry, int resolution);

/// Returns one picture right of another, on white.
Image beside(const Image& left, const Image& right);

}  // namespace gradmesh
